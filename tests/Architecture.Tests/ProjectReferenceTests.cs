using System.Xml.Linq;

namespace Harvester.Architecture.Tests;

/// <summary>The arrows between projects, as docs/architecture.md draws them, read from the project files.</summary>
public sealed class ProjectReferenceTests
{
    private static readonly Dictionary<string, string[]> Allowed = new(StringComparer.Ordinal)
    {
        ["Harvester.Geometry"] = [],
        ["Harvester.Sessions"] = ["Harvester.Geometry"],
        ["Harvester.Pages"] = ["Harvester.Sessions"],
        ["Harvester.Capture"] = ["Harvester.Sessions"],
        ["Harvester.Driving"] = ["Harvester.Capture"],
        ["Harvester.Play"] = ["Harvester.Driving"],
        ["Harvester.Mod"] = ["ScriptHookVDotNet3"],
        ["Harvester.Tapes"] = ["Harvester.Play"],
        ["Harvester.Simulation"] = ["Harvester.Capture"],
        ["Harvester.Datasets"] = ["Harvester.Sessions"],
        ["Harvester.Exports"] = ["Harvester.Datasets"],
        ["Harvester.Reports"] = ["Harvester.Exports", "Harvester.Pages"],
        ["Harvester.Runs"] = ["Harvester.Simulation", "Harvester.Driving", "Harvester.Datasets", "Harvester.Pages"],
        ["Harvester.Viewer"] = ["Harvester.Reports"],
        ["Harvester.Cli"] = ["Harvester.Reports", "Harvester.Runs", "Harvester.Tapes", "Harvester.Viewer"],
    };

    public static TheoryData<string> Projects =>
        new(
            Directory
                .EnumerateFiles(Path.Combine(Repository.Root, "src"), "*.csproj", SearchOption.AllDirectories)
                .Select(path => Path.GetFileNameWithoutExtension(path)!)
                .Order(StringComparer.Ordinal)
        );

    [Theory]
    [MemberData(nameof(Projects))]
    public void Project_refers_only_to_projects_below_it(string project)
    {
        IEnumerable<string> references = ProjectFile(project)
            .Descendants("ProjectReference")
            .Select(reference => Path.GetFileNameWithoutExtension(reference.Attribute("Include")!.Value.Replace('\\', '/')));

        Assert.True(Allowed.ContainsKey(project), $"{project} has no place in the architecture.");
        Assert.Empty(references.Except(Allowed[project]));
    }

    [Theory]
    [InlineData("Harvester.Geometry")]
    [InlineData("Harvester.Sessions")]
    [InlineData("Harvester.Capture")]
    [InlineData("Harvester.Driving")]
    [InlineData("Harvester.Play")]
    public void Project_that_loads_into_the_game_has_no_package_there(string project)
    {
        IEnumerable<string> packages = ProjectFile(project)
            .Descendants("PackageReference")
            .Where(reference => !IsForOtherFrameworkOnly(reference) && reference.Attribute("IncludeAssets")?.Value != "compile")
            .Select(reference => reference.Attribute("Include")!.Value);

        Assert.Empty(packages);
    }

    [Fact]
    public void Only_mod_and_tapes_name_the_games_scripting_api()
    {
        IEnumerable<string> offenders = Directory
            .EnumerateFiles(Path.Combine(Repository.Root, "src"), "*.cs", SearchOption.AllDirectories)
            .Where(path =>
                !path.Contains("Harvester.Mod", StringComparison.Ordinal)
                && !path.Contains("Harvester.Tapes", StringComparison.Ordinal)
                && !path.Contains("/obj/", StringComparison.Ordinal)
            )
            .Where(path => File.ReadLines(path).Any(line => line.StartsWith("using GTA", StringComparison.Ordinal)));

        Assert.Empty(offenders);
    }

    private static bool IsForOtherFrameworkOnly(XElement reference) =>
        $"{reference.Attribute("Condition")?.Value} {reference.Parent?.Attribute("Condition")?.Value}".Contains(
            "net10.0",
            StringComparison.Ordinal
        );

    private static XDocument ProjectFile(string project) => XDocument.Load(PathOf(project));

    private static string PathOf(string project) => Path.Combine(Repository.Root, "src", project, project + ".csproj");
}
