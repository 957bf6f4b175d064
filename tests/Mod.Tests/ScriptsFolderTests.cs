namespace Harvester.Mod.Tests;

/// <summary>The folder that the build makes is what the player copies.</summary>
public sealed class ScriptsFolderTests
{
    private static readonly string Folder = Path.Combine(BuiltMod.RepositoryRoot, "artifacts", BuiltMod.Configuration, "scripts");

    [Fact]
    public void Build_creates_a_folder_with_exactly_the_scripts_content()
    {
        Assert.Equal(
            [
                "GtaDataHarvester-LICENSE.txt", "GtaDataHarvester-rigs", "GtaDataHarvester.dll", "GtaDataHarvester.ini", "INSTALL.txt",
                "materials.csv", "spaces_of_interest.csv",
            ],
            Directory.EnumerateFileSystemEntries(Folder).Select(Path.GetFileName).Order(StringComparer.Ordinal));
    }

    [Fact]
    public void Example_rigs_are_in_the_folder() => Assert.Equal(
        ["kitti.json", "nuscenes-half.json", "nuscenes.json", "stereo.json", "thesis.json"],
        Directory.EnumerateFileSystemEntries(Path.Combine(Folder, "GtaDataHarvester-rigs")).Select(Path.GetFileName)
            .Order(StringComparer.Ordinal));

    [Fact]
    public void Dll_in_the_folder_is_the_one_that_was_built()
    {
        Assert.Equal(File.ReadAllBytes(BuiltMod.Path), File.ReadAllBytes(Path.Combine(Folder, "GtaDataHarvester.dll")));
    }

    [Fact]
    public void Install_names_every_file_of_the_folder()
    {
        string install = File.ReadAllText(Path.Combine(Folder, "INSTALL.txt"));

        Assert.All(Directory.EnumerateFileSystemEntries(Folder), file =>
            Assert.Contains(Path.GetFileName(file), install, StringComparison.Ordinal));
    }
}
