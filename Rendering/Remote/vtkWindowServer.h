// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindowServer
 * @brief   shows a render window in browsers
 *
 * Serves a page that shows the pictures of a window and sends the mouse, touches and keys to the
 * interactor of the window. The window can be on a display or off-screen:
 *
 *     server->SetRenderWindow(window);
 *     server->Start();
 *     cout << server->GetURL() << endl;
 *     while (server->ProcessRequests(0.1)) {}
 *
 * Browsers get JPEG pictures while the view changes, and a lossless picture (PNG) when it has been
 * still for StillDelay. Each browser confirms the pictures that it has shown, and at most two are
 * on their way. So a slow connection gets fewer pictures, but no old ones, and does not slow down
 * the window. While nothing changes, no frame is drawn and nothing is sent.
 *
 * An off-screen window without an interactor gets one, with the style
 * vtkInteractorStyleTrackballCamera. Set another style with
 * window->GetInteractor()->SetInteractorStyle().
 *
 * All VTK and OpenGL calls are in the thread that calls ProcessRequests(). Call it often.
 *
 * The server listens at 127.0.0.1 by default, so that only programs of this computer reach it. Each
 * request needs the token, which is a part of the URL. Requests of pages of other sites are
 * refused, by the headers Host and Origin. The connection is not encrypted: to reach the server
 * from other computers, forward the port with `ssh -L`. Malformed messages are ignored with a
 * warning, and a client that sends a message of more than 256 bytes is disconnected.
 *
 * @sa vtkRenderWindow vtkRenderWindowInteractor
 */
#ifndef vtkWindowServer_h
#define vtkWindowServer_h

#include "RelevoRenderingRemoteModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkRenderWindow;

class RELEVORENDERINGREMOTE_EXPORT vtkWindowServer : public vtkObject
{
public:
  static vtkWindowServer* New();
  vtkTypeMacro(vtkWindowServer, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the window. A window without an interactor gets one that has only the events of browsers.
   */
  virtual void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();
  //@}

  //@{
  /**
   * Set the port for the next Start(), 0 to 65535. 0 is any free port. Default 0.
   */
  virtual void SetPort(int port);
  vtkGetMacro(Port, int);
  //@}

  /**
   * Get the port that the server uses, or 0 if it does not run.
   */
  int GetActivePort();

  //@{
  /**
   * Set the numeric address to listen at, for the next Start(). Default 127.0.0.1, which other
   * computers cannot reach. 0.0.0.0 is all addresses of this computer.
   */
  virtual void SetAddress(const std::string& address);
  virtual std::string GetAddress();
  //@}

  //@{
  /**
   * Set the token for the next Start(): letters, digits and the characters - . _ ~, at most 128. An
   * empty text makes a random one. Default: 128 random bits of the system, as 32 hexadecimal
   * digits.
   */
  virtual void SetToken(const std::string& token);
  virtual std::string GetToken();
  //@}

  /**
   * Get the URL of the page, with the token, or an empty text if the server does not run.
   */
  std::string GetURL();

  //@{
  /**
   * Set the quality of JPEG pictures, 1 to 100. Default 80.
   */
  virtual void SetJPEGQuality(int quality);
  vtkGetMacro(JPEGQuality, int);
  //@}

  //@{
  /**
   * Set the seconds without a new frame until browsers get a lossless picture, 0 to 3600. With 0,
   * all pictures are lossless. Default 0.2.
   */
  virtual void SetStillDelay(double seconds);
  vtkGetMacro(StillDelay, double);
  //@}

  //@{
  /**
   * Set whether the window takes the size of the browser's window in device pixels, at most 8192 x
   * 8192, and the DPI that matches its pixels. With several browsers, the one that was resized last
   * sets the size. Default on.
   */
  vtkSetMacro(AllowResizing, bool);
  vtkGetMacro(AllowResizing, bool);
  vtkBooleanMacro(AllowResizing, bool);
  //@}

  /**
   * Start to listen. Returns false after an ErrorEvent if there is no window or the port cannot be
   * opened. Does nothing if the server runs.
   */
  bool Start();

  /**
   * Handle the events of browsers, draw a frame if they require one, and send pictures, for this
   * time in seconds. With 0, handle only what waits. Returns whether the server runs.
   */
  bool ProcessRequests(double seconds = 0.0);

  /**
   * Disconnect all browsers and close the port. You can start again.
   */
  void Stop();

  /**
   * Return whether the server runs.
   */
  bool IsRunning();

  //@{
  /**
   * Get the number of connected browsers, of pictures that they were sent since Start(), and of
   * frames that were read back for that.
   */
  int GetNumberOfClients();
  vtkTypeInt64 GetNumberOfPictures();
  vtkTypeInt64 GetNumberOfReadFrames();
  //@}

protected:
  vtkWindowServer();
  ~vtkWindowServer() override;

private:
  vtkWindowServer(const vtkWindowServer&) = delete;
  void operator=(const vtkWindowServer&) = delete;

  void OnFrame();
  void HandleMessages();
  void UpdatePicture();
  void ReadPicture(bool isStill);

  int Port = 0;
  int JPEGQuality = 80;
  double StillDelay = 0.2;
  bool AllowResizing = true;

  struct Internals;
  std::unique_ptr<Internals> State;
};

#endif
