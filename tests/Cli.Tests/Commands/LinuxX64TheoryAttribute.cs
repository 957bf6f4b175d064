using System.Runtime.InteropServices;

namespace Harvester.Cli.Tests.Commands;

/// <summary>A theory about bytes that depend on how mathematical functions round.</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class LinuxX64TheoryAttribute : TheoryAttribute
{
    public LinuxX64TheoryAttribute()
    {
        Skip = OperatingSystem.IsLinux() && RuntimeInformation.ProcessArchitecture == Architecture.X64 ? null : "Recorded on Linux x64.";
    }
}
