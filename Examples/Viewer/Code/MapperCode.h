// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   adds mappers to the program of a scene
 */
#ifndef MapperCode_h
#define MapperCode_h

#include <string>

class SceneCode;
class vtkAbstractMapper;
class vtkMapper;

/// Returns the variable of a mapper of a surface, a section or a terrain. Throws ViewerError for
/// other mappers.
std::string AddMapperCode(SceneCode& code, vtkMapper* mapper);

/// Adds the planes that clip a mapper.
void AddClippingCode(SceneCode& code, const std::string& variable, vtkAbstractMapper* mapper);

#endif
