using Harvester.TestSupport;

namespace Harvester.Architecture.Tests;

/// <summary>The repository that these tests were built from.</summary>
internal static class Repository
{
    public static string Root { get; } = RepositoryFolder.Path;

    /// <summary>The C# sources of a project, or of all, in a folder of the repository, without what the build generates.</summary>
    public static IEnumerable<string> SourcesOf(string project, string folder = "src")
    {
        string root = Path.Combine(Root, folder, project);
        return Directory
            .EnumerateFiles(root, "*.cs", SearchOption.AllDirectories)
            .Where(path => !Path.GetRelativePath(root, path).Split(Path.DirectorySeparatorChar).Any(part => part is "bin" or "obj"));
    }

    /// <summary>The assembly that a project was built to.</summary>
    public static string AssemblyOf(string project) =>
        project switch
        {
            "Harvester.Mod" => Path.Combine(Root, "artifacts", Configuration, "scripts", "GtaDataHarvester.dll"),
            "Harvester.Cli" => Path.Combine(AppContext.BaseDirectory, "harvester.dll"),
            _ => Path.Combine(AppContext.BaseDirectory, project + ".dll"),
        };

    // The tests lie in bin/CONFIGURATION/FRAMEWORK/.
    private static string Configuration =>
        Path.GetFileName(Path.GetDirectoryName(Path.TrimEndingDirectorySeparator(AppContext.BaseDirectory)))!;
}
