using System.Runtime.InteropServices;

namespace Harvester.Play.Screen.Windows;

/// <summary>
/// Whether a monitor shows HDR, by the structures of wingdi.h. Windows' Auto HDR needs such a monitor too. Available from Windows 10,
/// version 1709 on.
/// </summary>
internal static class AdvancedColour
{
    private const uint OnlyActivePaths = 2;
    private const int Success = 0;

    /// <summary>Bytes of a DISPLAYCONFIG_PATH_INFO and a DISPLAYCONFIG_MODE_INFO.</summary>
    private const int PathBytes = 72;
    private const int ModeBytes = 64;

    /// <summary>Where a path has the adapter (8 bytes) and the number (4 bytes) of its target.</summary>
    private const int TargetOfPath = 20;
    private const int TargetBytes = 12;

    /// <summary>DISPLAYCONFIG_GET_ADVANCED_COLOR_INFO: type, size, adapter and number of the target, flags, encoding, bits.</summary>
    private const int InfoType = 9;
    private const int InfoBytes = 32;
    private const int TargetOfInfo = 8;
    private const int FlagsOfInfo = 20;
    private const int IsEnabledFlag = 2;

    /// <summary>Whether any active monitor shows HDR; null if Windows does not report it.</summary>
    public static bool? IsOnAnyMonitor()
    {
        try
        {
            return GetDisplayConfigBufferSizes(OnlyActivePaths, out uint paths, out uint modes) == Success ? IsOn(paths, modes) : null;
        }
        catch (Exception exception) when (exception is DllNotFoundException or EntryPointNotFoundException)
        {
            return null;
        }
    }

    private static bool? IsOn(uint pathCount, uint modeCount)
    {
        byte[] paths = new byte[pathCount * PathBytes];
        byte[] modes = new byte[modeCount * ModeBytes];
        if (QueryDisplayConfig(OnlyActivePaths, ref pathCount, paths, ref modeCount, modes, IntPtr.Zero) != Success)
        {
            return null;
        }

        bool? isOn = null;
        for (int path = 0; path < pathCount; path++)
        {
            byte[] info = new byte[InfoBytes];
            BitConverter.GetBytes(InfoType).CopyTo(info, 0);
            BitConverter.GetBytes(InfoBytes).CopyTo(info, sizeof(int));
            Buffer.BlockCopy(paths, (path * PathBytes) + TargetOfPath, info, TargetOfInfo, TargetBytes);
            if (DisplayConfigGetDeviceInfo(info) == Success)
            {
                isOn = isOn == true || (info[FlagsOfInfo] & IsEnabledFlag) != 0;
            }
        }

        return isOn;
    }

    [DllImport("user32")]
    private static extern int GetDisplayConfigBufferSizes(uint flags, out uint paths, out uint modes);

    [DllImport("user32")]
    private static extern int QueryDisplayConfig(
        uint flags,
        ref uint pathCount,
        [Out] byte[] paths,
        ref uint modeCount,
        [Out] byte[] modes,
        IntPtr topology
    );

    [DllImport("user32")]
    private static extern int DisplayConfigGetDeviceInfo([In, Out] byte[] info);
}
