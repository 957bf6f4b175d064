namespace Harvester.Play.Screen.Windows;

/// <summary>
/// While an instance exists, the calling thread sees the desktop in physical pixels, whatever awareness of scaling its process has
/// declared; disposing restores the thread's own. Before Windows 10 1607 this switch does not exist: the process's own awareness decides,
/// and GTA V declares it.
/// </summary>
internal readonly struct PhysicalPixels : IDisposable
{
    private static readonly IntPtr PerMonitorAware = new(-3);
    private readonly IntPtr _before;

    private PhysicalPixels(IntPtr before)
    {
        _before = before;
    }

    public static PhysicalPixels Enter() => new(Set(PerMonitorAware));

    public void Dispose()
    {
        if (_before != IntPtr.Zero)
        {
            Set(_before);
        }
    }

    private static IntPtr Set(IntPtr context)
    {
        try
        {
            return User32.SetThreadDpiAwarenessContext(context);
        }
        catch (EntryPointNotFoundException)
        {
            return IntPtr.Zero;
        }
    }
}
