namespace Harvester.Cli.Tests;

/// <summary>As <see cref="PosixFactAttribute"/>, with data.</summary>
public sealed class PosixTheoryAttribute : TheoryAttribute
{
    public PosixTheoryAttribute()
    {
        Skip = OperatingSystem.IsWindows() ? "Needs a POSIX shell." : null;
    }
}
