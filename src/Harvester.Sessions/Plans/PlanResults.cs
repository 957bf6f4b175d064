using Harvester.Sessions.Files;

namespace Harvester.Sessions.Plans;

/// <summary>
/// The layout of the folder with a plan's results, the same in the game and from the command: copies of the plan and of what it depends on,
/// and a session for each trial.
/// </summary>
/// <param name="folder">The folder.</param>
public sealed class PlanResults(string folder)
{
    /// <summary>Name of the copy of the plan.</summary>
    public const string PlanCopy = "plan.json";

    /// <summary>Longest copy that is compared, characters.</summary>
    private const int MaxCharacters = 16 << 20;

    /// <summary>The folder.</summary>
    public string Folder => folder;

    /// <summary>The folder with the sessions.</summary>
    public string Trials => Path.Combine(folder, "trials");

    /// <summary>What is wrong with a folder whose copy is another plan: a sentence, which the caller's advice follows.</summary>
    public string OfAnotherPlan => $"'{folder}' has results of another plan, or of this one before it was changed.";

    /// <summary>The folder of a trial's session.</summary>
    /// <exception cref="ArgumentNullException"><paramref name="trial"/> is null.</exception>
    public string FolderOf(Trial trial) => Path.Combine(Trials, (trial ?? throw new ArgumentNullException(nameof(trial))).Id);

    /// <summary>Writes a copy, or compares the one that is there.</summary>
    /// <param name="name">Its path within the folder.</param>
    /// <param name="text">What the results depend on.</param>
    /// <returns>Whether the copy has the text; otherwise the folder has other results.</returns>
    /// <exception cref="IOException">It cannot be written or read.</exception>
    public bool Keep(string name, string text)
    {
        string path = Path.Combine(folder, name);
        return AtomicFile.TryWriteNew(path, text) || ReadText(path) == text;
    }

    /// <summary>Reads a plan or a file that belongs to it, at most 16 million characters.</summary>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static string ReadText(string path)
    {
        using var reader = new StreamReader(RegularFile.OpenRead(path));
        char[] text = new char[MaxCharacters];
        return new string(text, 0, reader.ReadBlock(text, 0, MaxCharacters));
    }
}
