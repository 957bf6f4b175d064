using System.Diagnostics;

namespace Harvester.Mod.Tests;

/// <summary>
/// A copy of what the mod is built from, built by the SDK as a user would, away from what these tests themselves were built from.
/// </summary>
internal sealed class ModBuild : IDisposable
{
    private static readonly string[] Folders =
    [
        "build",
        "data",
        "docs/images/mod",
        "ref",
        "src/Polyfills",
        "src/Harvester.Geometry",
        "src/Harvester.Sessions",
        "src/Harvester.Capture",
        "src/Harvester.Driving",
        "src/Harvester.Play",
        "src/Harvester.Mod",
    ];

    private static readonly string[] Files =
    [
        "Directory.Build.props",
        "Directory.Packages.props",
        "global.json",
        ".editorconfig",
        "LICENSE",
        "src/Directory.Build.targets",
        "docs/mod.md",
    ];

    private readonly TemporaryFolder _folder = new();

    public ModBuild()
    {
        foreach (string file in Files.Concat(Folders.SelectMany(FilesIn)))
        {
            string copy = PathOf(file);
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(Path.Combine(BuiltMod.RepositoryRoot, file), copy);
        }
    }

    /// <summary>The path of a file of the repository in the copy.</summary>
    public string PathOf(string file) => Path.Combine(_folder.Path, file);

    /// <summary>Builds the mod; returns the exit code and everything that was printed.</summary>
    /// <param name="properties">As on the command line, such as -p:GameApi=file.</param>
    public (int ExitCode, string Output) Build(params string[] properties)
    {
        var start = new ProcessStartInfo(
            "dotnet",
            ["build", "-c", "Release", "src/Harvester.Mod", "-nodeReuse:false", "-p:UseSharedCompilation=false", .. properties]
        )
        {
            WorkingDirectory = _folder.Path,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };

        // What the test runner has set for its own MSBuild is not the user's.
        foreach (
            string name in start.Environment.Keys.Where(name => name.StartsWith("MSBUILD", StringComparison.OrdinalIgnoreCase)).ToArray()
        )
        {
            start.Environment.Remove(name);
        }

        start.Environment["DOTNET_CLI_UI_LANGUAGE"] = "en";
        using Process build = Process.Start(start)!;
        Task<string> errors = build.StandardError.ReadToEndAsync();
        string output = build.StandardOutput.ReadToEnd();
        build.WaitForExit();
        return (build.ExitCode, output + errors.Result);
    }

    public void Dispose() => _folder.Dispose();

    private static IEnumerable<string> FilesIn(string folder) =>
        Directory
            .EnumerateFiles(Path.Combine(BuiltMod.RepositoryRoot, folder), "*", SearchOption.AllDirectories)
            .Select(file => Path.GetRelativePath(BuiltMod.RepositoryRoot, file))
            .Where(file => !file.Split(Path.DirectorySeparatorChar).Any(part => part is "bin" or "obj"));
}
