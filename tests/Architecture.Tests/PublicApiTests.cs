using System.Reflection;
using System.Text.RegularExpressions;
using PublicApiGenerator;

namespace Harvester.Architecture.Tests;

/// <summary>
/// The public surface of each package is the one that PublicApi/PROJECT.txt shows, so that no change of it goes unseen. A change on purpose
/// is approved by running these tests with GTADATAHARVESTER_APPROVE=1, which stores the new surface.
/// </summary>
public sealed partial class PublicApiTests
{
    private const string ApprovalVariable = "GTADATAHARVESTER_APPROVE";

    private static string ApprovedFolder => Path.Combine(Repository.Root, "tests", "Architecture.Tests", "PublicApi");

    public static TheoryData<string> Packages => [.. PackagesOfARelease()];

    [Theory]
    [MemberData(nameof(Packages))]
    public void Public_surface_of_a_package_is_the_approved_one(string project)
    {
        string surface = Surface(Assembly.LoadFrom(Repository.AssemblyOf(project)));
        string approved = Path.Combine(ApprovedFolder, project + ".txt");
        if (Environment.GetEnvironmentVariable(ApprovalVariable) == "1")
        {
            File.WriteAllText(approved, surface);
        }

        Assert.True(File.Exists(approved), $"{project} has no approved surface. Run the tests with {ApprovalVariable}=1.");
        Assert.Equal(File.ReadAllText(approved), surface);
    }

    [Fact]
    public void Only_packages_have_an_approved_surface() =>
        Assert.Equal(
            PackagesOfARelease().Order(),
            Directory.EnumerateFiles(ApprovedFolder).Select(Path.GetFileNameWithoutExtension).Order()
        );

    private static string Surface(Assembly assembly)
    {
        var options = new ApiGeneratorOptions { IncludeAssemblyAttributes = false, OrderBy = OrderMode.FullName };
        return assembly.GeneratePublicApi(options).ReplaceLineEndings("\n") + "\n";
    }

    private static string[] PackagesOfARelease()
    {
        string script = File.ReadAllText(Path.Combine(Repository.Root, "build", "release"));
        return
        [
            .. PackedProjects().Match(script).Groups[1].Value.Split(' ').Where(name => name != "Cli").Select(name => "Harvester." + name),
        ];
    }

    [GeneratedRegex(@"^for project in (.+); do$", RegexOptions.Multiline)]
    private static partial Regex PackedProjects();
}
