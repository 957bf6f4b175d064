namespace Harvester.TestSupport;

/// <summary>A test that needs signals and a POSIX shell; it is skipped on Windows.</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class PosixFactAttribute : FactAttribute
{
    public PosixFactAttribute()
    {
        Skip = OperatingSystem.IsWindows() ? "Needs a POSIX shell." : null;
    }
}
