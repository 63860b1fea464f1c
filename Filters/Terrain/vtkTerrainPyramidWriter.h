// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainPyramidWriter
 * @brief   copies a height raster into a file with overviews
 *
 * The result is a tiled BigTIFF with lossless compression. Samples keep their type and value. The
 * georeference, the no-data value, scale, offset and unit are kept, and tiles that a sparse raster
 * does not store stay unstored. Only the first band is copied. Each sample of an overview is the
 * mean of the samples with data among the 2 x 2 below it; levels follow until both sides have at
 * most 256 samples.
 *
 * The output file appears when it is complete. If Write() is interrupted in any way, the next
 * Write() for the same files goes on from the last part that is on the disk. Until then the part
 * is a hidden file beside the output.
 *
 * Errors (ErrorEvent; Write() returns false and leaves the output file as it was): no file names;
 * an input that is missing, unreadable, complex, or declares missing samples by a mask; an output
 * that is the input, that cannot be written, or that another process is writing; a compression that
 * GDAL lacks; a build without GDAL.
 *
 * By default, Write() also writes the index that vtkTerrainPyramid uses, FileName.relevo-index. If
 * Write() is interrupted meanwhile, the next Write() only makes the index.
 *
 * ProgressEvent reports the fraction of the current step that is complete, see GetStep(). An
 * observer can call AbortExecuteOn() to stop.
 *
 * @sa vtkTerrainPyramid
 */
#ifndef vtkTerrainPyramidWriter_h
#define vtkTerrainPyramidWriter_h

#include "RelevoFiltersTerrainModule.h" // for export macro
#include "vtkObject.h"

#include <string> // for messages

class RELEVOFILTERSTERRAIN_EXPORT vtkTerrainPyramidWriter : public vtkObject
{
public:
  static vtkTerrainPyramidWriter* New();
  vtkTypeMacro(vtkTerrainPyramidWriter, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the name of the raster to copy: any name that GDAL knows.
   */
  vtkSetFilePathMacro(InputFileName);
  vtkGetFilePathMacro(InputFileName);
  //@}

  //@{
  /**
   * Set the name of the file to write.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  enum CompressionType
  {
    NONE = 0,
    DEFLATE = 1,
    LZW = 2,
    ZSTD = 3
  };

  //@{
  /**
   * Set the compression, by default DEFLATE. All of them are lossless. ZSTD is faster, but not
   * every build of GDAL has it. Another value is an error and changes nothing.
   */
  virtual void SetCompression(int compression);
  vtkGetMacro(Compression, int);
  void SetCompressionToNone() { this->SetCompression(NONE); }
  void SetCompressionToDeflate() { this->SetCompression(DEFLATE); }
  void SetCompressionToLZW() { this->SetCompression(LZW); }
  void SetCompressionToZSTD() { this->SetCompression(ZSTD); }
  //@}

  //@{
  /**
   * Set whether the index is also written, by default on. Without it, vtkTerrainPyramid makes the
   * index when it opens the file.
   */
  vtkSetMacro(WriteIndex, bool);
  vtkGetMacro(WriteIndex, bool);
  vtkBooleanMacro(WriteIndex, bool);
  //@}

  enum StepType
  {
    COPY = 0,
    INDEX = 1
  };

  /// Return the current step of a running Write(): COPY writes the samples and overviews, INDEX
  /// makes the index.
  int GetStep() { return this->Step; }

  //@{
  /**
   * Stop a running Write(), which then returns false without an error.
   */
  vtkSetMacro(AbortExecute, bool);
  vtkGetMacro(AbortExecute, bool);
  vtkBooleanMacro(AbortExecute, bool);
  //@}

  /// Write the file. Returns whether it is complete.
  bool Write();

  /// Return the message of the last ErrorEvent, without class and line; "" if there was none.
  const char* GetErrorMessage() { return this->ErrorMessage.c_str(); }

protected:
  vtkTerrainPyramidWriter();
  ~vtkTerrainPyramidWriter() override;

  char* InputFileName;
  char* FileName;
  int Compression;
  bool WriteIndex;
  bool AbortExecute;

private:
  vtkTerrainPyramidWriter(const vtkTerrainPyramidWriter&) = delete;
  void operator=(const vtkTerrainPyramidWriter&) = delete;

  bool Report(const std::string& error);

  std::string ErrorMessage;
  int Step;
};

#endif
