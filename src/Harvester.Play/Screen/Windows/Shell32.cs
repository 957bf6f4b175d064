using System.Runtime.InteropServices;

namespace Harvester.Play.Screen.Windows;

/// <summary>The state of the user's display, declared as in shellapi.h.</summary>
internal static class Shell32
{
    /// <summary>A Direct3D program runs in exclusive full screen.</summary>
    public const int RunningFullScreen = 3;

    [DllImport("shell32")]
    public static extern int SHQueryUserNotificationState(out int state);
}
