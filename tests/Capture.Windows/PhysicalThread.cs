namespace Harvester.Capture.Windows;

/// <summary>
/// Windows are made and moved in physical pixels; outside of this the thread stays as unaware of scaling as a mod's host may be.
/// </summary>
internal readonly struct PhysicalThread : IDisposable
{
    private readonly IntPtr _before;

    private PhysicalThread(IntPtr before)
    {
        _before = before;
    }

    public static PhysicalThread Enter() => new(Native.SetThreadDpiAwarenessContext(Native.PerMonitorAware));

    public void Dispose() => Native.SetThreadDpiAwarenessContext(_before);
}
