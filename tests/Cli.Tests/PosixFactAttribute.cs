namespace Harvester.Cli.Tests;

/// <summary>A test that needs signals and a POSIX shell.</summary>
public sealed class PosixFactAttribute : FactAttribute
{
    public PosixFactAttribute()
    {
        Skip = OperatingSystem.IsWindows() ? "Needs a POSIX shell." : null;
    }
}
