namespace Harvester.TestSupport;

/// <summary>
/// A test over data of the real game, which is never part of the project. The data is looked for in the folder that the variable
/// GTADATAHARVESTER_REALWORLD names, or in shared/realworld beside any folder above the tests; where it is absent the test is
/// skipped and says so.
/// </summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class RealWorldFactAttribute : FactAttribute
{
    public RealWorldFactAttribute(string file)
    {
        if (PathOf(file) is null)
        {
            Skip = $"{file} of the game's data is not here; name its folder in GTADATAHARVESTER_REALWORLD to run this test.";
        }
    }

    public static string? PathOf(string file) => Folders().Select(folder => Path.Combine(folder, file)).FirstOrDefault(File.Exists);

    private static IEnumerable<string> Folders()
    {
        if (Environment.GetEnvironmentVariable("GTADATAHARVESTER_REALWORLD") is { Length: > 0 } named)
        {
            yield return named;
            yield break;
        }

        for (DirectoryInfo? folder = new(AppContext.BaseDirectory); folder is not null; folder = folder.Parent)
        {
            yield return Path.Combine(folder.FullName, "shared", "realworld");
        }
    }
}
