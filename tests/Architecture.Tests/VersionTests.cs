using System.Text.RegularExpressions;
using System.Xml.Linq;

namespace Harvester.Architecture.Tests;

/// <summary>The version of all that is released is written in build/Version.props, and the changelog says what it brings.</summary>
public sealed partial class VersionTests
{
    private static readonly string[] BuildFiles = ["*.csproj", "*.props", "*.targets", "pyproject.toml", "Dockerfile"];

    [Fact]
    public void Version_is_defined_in_one_file()
    {
        string[] files = [.. BuildFiles.SelectMany(FilesLike).Where(file => DefinesVersion().IsMatch(File.ReadAllText(file)))];

        Assert.Equal(["build/Version.props"], files.Select(file => Path.GetRelativePath(Repository.Root, file).Replace('\\', '/')));
    }

    // The folder python can be installed on its own, without build/Version.props.
    [Fact]
    public void Python_package_repeats_the_version()
    {
        string version = Regex
            .Match(File.ReadAllText(Path.Combine(Repository.Root, "build", "Version.props")), "<Version>(.+)</Version>")
            .Groups[1]
            .Value;

        Assert.Contains(
            $"__version__ = \"{version}\"",
            File.ReadAllText(Path.Combine(Repository.Root, "python", "src", "gtaharvest", "_version.py")),
            StringComparison.Ordinal
        );
    }

    [Theory]
    [InlineData("<Version>1.0.0</Version>")]
    [InlineData("<PackageVersion>1.0.0</PackageVersion>")]
    [InlineData("<AssemblyVersion>1.0</AssemblyVersion>")]
    [InlineData("version = \"1.0.0\"")]
    [InlineData("__version__ = \"1.0.0\"")]
    public void Definitions_of_a_version_are_recognised(string text) => Assert.Matches(DefinesVersion(), text);

    [Fact]
    public void Changelog_begins_with_what_is_not_released()
    {
        string[] sections = Sections();

        Assert.Equal("Unreleased", sections[0]);
        Assert.Equal(sections.Distinct(), sections);
    }

    [Fact]
    public void Newest_section_of_the_changelog_is_no_future_version()
    {
        XDocument properties = XDocument.Load(Path.Combine(Repository.Root, "build", "Version.props"));
        Version current = Version.Parse((string)properties.Descendants("Version").Single());
        Version[] released = [.. Sections().Skip(1).Select(Version.Parse)];

        Assert.All(released, version => Assert.True(version <= current));
        Assert.Equal(released.OrderDescending(), released);
    }

    private static string[] Sections() =>
        [
            .. File.ReadLines(Path.Combine(Repository.Root, "CHANGELOG.md"))
                .Select(line => SectionHeading().Match(line))
                .Where(heading => heading.Success)
                .Select(heading => heading.Groups[1].Value),
        ];

    private static IEnumerable<string> FilesLike(string pattern) =>
        Directory.EnumerateFiles(Repository.Root, pattern, SearchOption.AllDirectories).Where(IsSource);

    /// <summary>Without what is built, and without the stand-in in ref, whose version is that of the API it stands for.</summary>
    private static bool IsSource(string path) =>
        !Path.GetRelativePath(Repository.Root, path)
            .Split(Path.DirectorySeparatorChar)
            .Any(part => part is "bin" or "obj" or "artifacts" or "out" or "ref");

    [GeneratedRegex(@"<(Package|Assembly|File|Informational)?Version(Prefix)?>\d|^(__)?version(__)? = ""\d", RegexOptions.Multiline)]
    private static partial Regex DefinesVersion();

    [GeneratedRegex(@"^## \[([^\]]+)\]")]
    private static partial Regex SectionHeading();
}
