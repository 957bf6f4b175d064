using System.Text.Json;

namespace Harvester.Architecture.Tests;

/// <summary>Whoever receives the command also receives the licences of the packages in it.</summary>
public sealed class ThirdPartyNoticeTests
{
    [Fact]
    public void Every_package_of_the_command_has_its_notice()
    {
        string[] notices = File.ReadAllLines(Path.Combine(Repository.Root, "THIRD-PARTY-NOTICES.md"));
        (string Name, string Version)[] packages = [.. PackagesOf("src/Harvester.Cli")];

        Assert.NotEmpty(packages);
        Assert.All(
            packages,
            package =>
                Assert.Contains(
                    notices,
                    line =>
                        line.StartsWith($"| [{package.Name}](", StringComparison.Ordinal)
                        && line.Contains($" | {package.Version} | ", StringComparison.Ordinal)
                )
        );
    }

    [Fact]
    public void Projects_of_the_game_restore_no_package_that_ships()
    {
        string[] referenceAssemblies = ["Microsoft.NETFramework.ReferenceAssemblies", "Microsoft.NETFramework.ReferenceAssemblies.net472"];

        Assert.Equal(referenceAssemblies, PackagesOf("src/Harvester.Mod").Select(package => package.Name));
    }

    private static IEnumerable<(string Name, string Version)> PackagesOf(string project)
    {
        using FileStream file = File.OpenRead(Path.Combine(Repository.Root, project, "packages.lock.json"));
        using JsonDocument document = JsonDocument.Parse(file);
        JsonElement.ObjectEnumerator targets = document.RootElement.GetProperty("dependencies").EnumerateObject();
        foreach (JsonProperty library in targets.SelectMany(target => target.Value.EnumerateObject()))
        {
            if (library.Value.GetProperty("type").GetString() != "Project")
            {
                yield return (library.Name, library.Value.GetProperty("resolved").GetString()!);
            }
        }
    }
}
