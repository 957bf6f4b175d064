namespace Harvester.Cli.Tests.Repetition;

/// <summary>A test that compiles the fault injector; it is skipped where that is impossible.</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class CompilerFactAttribute : FactAttribute
{
    public CompilerFactAttribute()
    {
        Skip =
            !OperatingSystem.IsLinux() ? "Preloads a library, which is tested on Linux."
            : Environment.GetEnvironmentVariable("PATH")!.Split(':').Any(folder => File.Exists(Path.Combine(folder, "cc"))) ? null
            : "Needs a C compiler named cc.";
    }
}
