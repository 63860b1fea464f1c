// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEGLOffscreenRenderWindow.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // and with it GLEW up to VTK 9.3, GLAD from 9.4
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <vector>

namespace
{
// Return the displays to try, best first: every device (graphics cards come before Mesa's software
// device), Mesa without a window system, and the default of the environment.
std::vector<EGLDisplay> CandidateDisplays()
{
  std::vector<EGLDisplay> displays;
  const auto queryDevices =
    reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  const auto getPlatformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
    eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (getPlatformDisplay)
  {
    EGLint numberOfDevices = 0;
    if (queryDevices && queryDevices(0, nullptr, &numberOfDevices) && numberOfDevices > 0)
    {
      std::vector<EGLDeviceEXT> devices(numberOfDevices);
      queryDevices(numberOfDevices, devices.data(), &numberOfDevices);
      for (EGLDeviceEXT device : devices)
      {
        displays.push_back(getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
      }
    }
    displays.push_back(
      getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
  return displays;
}
}

struct vtkEGLOffscreenRenderWindow::EGLContextHolder
{
  // The context that is current in this thread.
  struct Current
  {
    EGLDisplay Display = eglGetCurrentDisplay();
    EGLSurface Draw = eglGetCurrentSurface(EGL_DRAW);
    EGLSurface Read = eglGetCurrentSurface(EGL_READ);
    EGLContext Context = eglGetCurrentContext();
  };
  std::vector<Current> Pushed;

  EGLDisplay Display = EGL_NO_DISPLAY;
  EGLSurface Surface = EGL_NO_SURFACE;
  EGLContext Context = EGL_NO_CONTEXT;

  // The display is not terminated, because all windows of the process share it.
  ~EGLContextHolder()
  {
    if (this->Context == eglGetCurrentContext())
    {
      eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    if (this->Surface != EGL_NO_SURFACE)
    {
      eglDestroySurface(this->Display, this->Surface);
    }
    if (this->Context != EGL_NO_CONTEXT)
    {
      eglDestroyContext(this->Display, this->Context);
    }
  }

  bool MakeCurrent() const
  {
    return eglMakeCurrent(this->Display, this->Surface, this->Surface, this->Context) == EGL_TRUE;
  }

  bool Create(EGLDisplay display)
  {
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) ||
      !eglBindAPI(EGL_OPENGL_API))
    {
      return false;
    }
    const EGLint wanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
      EGL_OPENGL_BIT, EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_DEPTH_SIZE, 24,
      EGL_NONE };
    EGLConfig config = nullptr;
    EGLint numberOfConfigs = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &numberOfConfigs) || numberOfConfigs < 1)
    {
      return false;
    }
    // VTK draws into its own framebuffers, so the smallest surface suffices.
    const EGLint size[] = { EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE };
    this->Display = display;
    this->Surface = eglCreatePbufferSurface(display, config, size);
    for (const auto& version :
      { std::pair<EGLint, EGLint>{ 4, 6 }, { 4, 5 }, { 4, 3 }, { 4, 0 }, { 3, 3 }, { 3, 2 } })
    {
      const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, version.first,
        EGL_CONTEXT_MINOR_VERSION, version.second, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
      this->Context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
      if (this->Context != EGL_NO_CONTEXT)
      {
        return this->MakeCurrent();
      }
    }
    return false;
  }
};

vtkStandardNewMacro(vtkEGLOffscreenRenderWindow);

//------------------------------------------------------------------------------
vtkEGLOffscreenRenderWindow::vtkEGLOffscreenRenderWindow()
{
  this->OwnContext = 1;
  this->SetOffScreenRendering(1);
  this->SetFrameBlitModeToNoBlit();
}

//------------------------------------------------------------------------------
vtkEGLOffscreenRenderWindow::~vtkEGLOffscreenRenderWindow()
{
  // The context must still exist, because renderers release their resources in it.
  this->MakeCurrent();
  this->Finalize();
  vtkCollectionSimpleIterator iterator;
  this->Renderers->InitTraversal(iterator);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(iterator))
  {
    renderer->SetRenderWindow(nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkEGLOffscreenRenderWindow::CreateContext()
{
  bool isBlocked = false;
  for (EGLDisplay display : CandidateDisplays())
  {
    auto context = std::make_unique<EGLContextHolder>();
    if (context->Create(display))
    {
      this->Context = std::move(context);
      return;
    }
    isBlocked = isBlocked || eglGetError() == EGL_BAD_ACCESS;
  }
  if (isBlocked)
  {
    vtkErrorMacro(
      "A window on a display already uses OpenGL in this thread: delete that window first.");
  }
  else
  {
    vtkErrorMacro("No EGL device supports OpenGL 3.2 with the core profile.");
  }
}

//------------------------------------------------------------------------------
void vtkEGLOffscreenRenderWindow::Initialize()
{
  if (!this->Context)
  {
    this->CreateContext();
    this->SetReadyForRendering(this->Context != nullptr);
  }
  if (this->Context && !this->Initialized)
  {
    this->OpenGLInit();
  }
}

//------------------------------------------------------------------------------
void vtkEGLOffscreenRenderWindow::MakeCurrent()
{
  if (this->Context && !this->IsCurrent())
  {
    this->Context->MakeCurrent();
  }
}

//------------------------------------------------------------------------------
bool vtkEGLOffscreenRenderWindow::IsCurrent()
{
  return this->Context && eglGetCurrentContext() == this->Context->Context;
}

//------------------------------------------------------------------------------
void vtkEGLOffscreenRenderWindow::PushContext()
{
  if (this->Context)
  {
    this->Context->Pushed.emplace_back();
    this->MakeCurrent();
  }
}

//------------------------------------------------------------------------------
void vtkEGLOffscreenRenderWindow::PopContext()
{
  if (!this->Context || this->Context->Pushed.empty())
  {
    return;
  }
  const EGLContextHolder::Current last = this->Context->Pushed.back();
  this->Context->Pushed.pop_back();
  if (last.Context != EGL_NO_CONTEXT && last.Context != eglGetCurrentContext())
  {
    eglMakeCurrent(last.Display, last.Draw, last.Read, last.Context);
  }
}

//------------------------------------------------------------------------------
void vtkEGLOffscreenRenderWindow::Render()
{
  this->Initialize();
  if (this->Initialized)
  {
    this->MakeCurrent();
    this->Superclass::Render();
  }
}

//------------------------------------------------------------------------------
void vtkEGLOffscreenRenderWindow::Finalize()
{
  if (this->Context && this->Initialized)
  {
    this->MakeCurrent();
    this->Superclass::Finalize();
  }
}

//------------------------------------------------------------------------------
void vtkEGLOffscreenRenderWindow::OpenGLInit()
{
  // The direct superclass would first save OpenGL's state. No other code has changed it here, and
  // saving needs the function pointers that are loaded by this call.
  this->MakeCurrent();
  this->vtkOpenGLRenderWindow::OpenGLInit();
}

//------------------------------------------------------------------------------
void vtkEGLOffscreenRenderWindow::OpenGLInitContext()
{
#ifdef GLEW_OK
  if (!this->Initialized)
  {
    // GLEW built for X11 loads all function pointers, and then reports that GLX is missing, which
    // is not needed here.
    const GLenum result = glewInit();
    this->GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
    if (!this->GlewInitValid || !GLEW_VERSION_3_2)
    {
      vtkErrorMacro("OpenGL's functions could not be loaded.");
      return;
    }
    this->ContextCreationTime.Modified();
    this->Initialized = true;
    GLfloat lineWidths[2] = { 1.0f, 1.0f };
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, lineWidths);
    this->MaximumHardwareLineWidth = lineWidths[1];
  }
#else
  this->SetOpenGLSymbolLoader(
    [](void*, const char* name) -> VTKOpenGLAPIProc { return eglGetProcAddress(name); }, nullptr);
  this->Superclass::OpenGLInitContext();
#endif
}

//------------------------------------------------------------------------------
void* vtkEGLOffscreenRenderWindow::GetGenericContext()
{
  return this->Context ? this->Context->Context : nullptr;
}

//------------------------------------------------------------------------------
int vtkEGLOffscreenRenderWindow::SupportsOpenGL()
{
  this->Initialize();
  return this->Initialized ? 1 : 0;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkEGLOffscreenRenderWindow::IsDirect()
{
  return 1;
}

//------------------------------------------------------------------------------
void vtkEGLOffscreenRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Context: " << this->GetGenericContext() << "\n";
}
