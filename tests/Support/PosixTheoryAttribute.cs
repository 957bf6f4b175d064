namespace Harvester.TestSupport;

/// <summary>As <see cref="PosixFactAttribute"/>, with data.</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class PosixTheoryAttribute : TheoryAttribute
{
    public PosixTheoryAttribute()
    {
        Skip = OperatingSystem.IsWindows() ? "Needs a POSIX shell." : null;
    }
}
