using System.Text.RegularExpressions;

namespace Harvester.Mod.Tests;

/// <summary>The folder that the build makes is what the player copies.</summary>
public sealed class ScriptsFolderTests
{
    private static readonly string Folder = Path.Combine(BuiltMod.RepositoryRoot, "artifacts", BuiltMod.Configuration, "scripts");

    private static readonly Regex PictureLink = new(@"!\[[^\]]*\]\(([^)]+)\)", RegexOptions.CultureInvariant);

    [Fact]
    public void Build_creates_a_folder_with_exactly_the_scripts_content()
    {
        Assert.Equal(
            [
                "GtaDataHarvester-LICENSE.txt",
                "GtaDataHarvester-guide",
                "GtaDataHarvester-rigs",
                "GtaDataHarvester.dll",
                "GtaDataHarvester.ini",
                "INSTALL.txt",
                "materials.csv",
                "spaces_of_interest.csv",
            ],
            Directory.EnumerateFileSystemEntries(Folder).Select(Path.GetFileName).Order(StringComparer.Ordinal)
        );
    }

    [Fact]
    public void Example_rigs_are_in_the_folder() =>
        Assert.Equal(
            ["kitti.json", "nuscenes-half.json", "nuscenes.json", "radar.json", "stereo.json", "thesis.json"],
            Directory
                .EnumerateFileSystemEntries(Path.Combine(Folder, "GtaDataHarvester-rigs"))
                .Select(Path.GetFileName)
                .Order(StringComparer.Ordinal)
        );

    [Fact]
    public void Guide_in_the_folder_has_all_its_pictures()
    {
        string guide = Path.Combine(Folder, "GtaDataHarvester-guide");
        string page = File.ReadAllText(Path.Combine(guide, "mod.md"));
        string[] pictures = [.. PictureLink.Matches(page).Select(link => link.Groups[1].Value)];

        Assert.NotEmpty(pictures);
        Assert.All(pictures, picture => Assert.True(File.Exists(Path.Combine(guide, picture)), picture));
    }

    [Theory]
    [InlineData("vc_redist.x64.exe")]
    [InlineData("Visual C++ 2019 x64")]
    [InlineData("dev-c.com/gtav/scripthookv")]
    [InlineData("github.com/scripthookvdotnet/scripthookvdotnet/releases")]
    [InlineData("dotnet-framework/net48")]
    [InlineData("Pause Game On Focus Loss")]
    public void Install_says_what_is_needed_and_where_it_is(string text) =>
        Assert.Contains(text, File.ReadAllText(Path.Combine(Folder, "INSTALL.txt")), StringComparison.Ordinal);

    [Fact]
    public void Dll_in_the_folder_is_the_one_that_was_built()
    {
        Assert.Equal(File.ReadAllBytes(BuiltMod.Path), File.ReadAllBytes(Path.Combine(Folder, "GtaDataHarvester.dll")));
    }

    [Fact]
    public void Install_names_every_file_of_the_folder()
    {
        string install = File.ReadAllText(Path.Combine(Folder, "INSTALL.txt"));

        Assert.All(
            Directory.EnumerateFileSystemEntries(Folder),
            file => Assert.Contains(Path.GetFileName(file), install, StringComparison.Ordinal)
        );
    }
}
