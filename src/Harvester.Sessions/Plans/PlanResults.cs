using Harvester.Sessions.Files;

namespace Harvester.Sessions.Plans;

/// <summary>
/// The folder with a plan's results, locked, the same in the game and from the command: copies of the plan and of what it depends on, the
/// status of the trials, a session for each trial, and what attempts left that did not end well.
/// </summary>
/// <param name="folder">The folder.</param>
/// <param name="held">What keeps others from writing to it, released with this object.</param>
public sealed class PlanResults(string folder, IDisposable held) : IDisposable
{
    /// <summary>Name of the copy of the plan.</summary>
    public const string PlanCopy = "plan.json";

    private const string Unfinished = "unfinished";

    /// <summary>Longest copy that is compared, characters.</summary>
    private const int MaxCharacters = 16 << 20;

    /// <summary>The folder.</summary>
    public string Folder => folder;

    /// <summary>The folder with the sessions.</summary>
    public string Trials => Path.Combine(folder, "trials");

    /// <summary>What is wrong with a folder whose copy is another plan: a sentence, which the caller's advice follows.</summary>
    public string OfAnotherPlan => $"'{folder}' has results of another plan, or of this one before it was changed.";

    /// <summary>How the trials ended.</summary>
    /// <exception cref="InvalidOperationException"><see cref="ReadStatus"/> was not called.</exception>
    public PlanStatus Status
    {
        get => field ?? throw new InvalidOperationException("The status of the trials was not read.");
        private set;
    }

    /// <summary>Whether a part of the plan was begun before.</summary>
    /// <param name="shard">The part.</param>
    public bool HasResults(Shard shard) =>
        File.Exists(Path.Combine(folder, PlanStatus.FileNameOf(shard))) || (shard.Count == 1 && Directory.Exists(Trials));

    /// <summary>Reads how the trials of a part of the plan ended.</summary>
    /// <param name="shard">The part.</param>
    /// <exception cref="FormatException">A line is not a result; the message names file and line.</exception>
    /// <exception cref="IOException">The file is a link, or cannot be read.</exception>
    public void ReadStatus(Shard shard) => Status = PlanStatus.Open(folder, shard);

    /// <summary>The trials that need an attempt, in their order; each is looked up when it is reached.</summary>
    public IEnumerable<Trial> Left(IEnumerable<Trial> trials) => trials.Where(trial => Status.NextAttempt(trial.Id) is not null);

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

    /// <summary>
    /// Moves what an attempt wrote to a folder of its own within the folder unfinished, for a game that cannot continue it because it does
    /// not take the same course again.
    /// </summary>
    /// <exception cref="IOException">The folder cannot be moved.</exception>
    public void SetAside(Trial trial)
    {
        string written = FolderOf(trial);
        if (!Directory.Exists(written))
        {
            return;
        }

        string aside = Path.Combine(folder, Unfinished);
        Directory.CreateDirectory(aside);
        string free = Path.Combine(aside, trial.Id);
        for (int number = 2; Directory.Exists(free); number++)
        {
            free = FormattableString.Invariant($"{Path.Combine(aside, trial.Id)}-{number}");
        }

        Directory.Move(written, free);
    }

    /// <summary>Releases the folder.</summary>
    public void Dispose() => held.Dispose();

    /// <summary>Reads a plan or a file that belongs to it, at most 16 million characters.</summary>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static string ReadText(string path)
    {
        using var reader = new StreamReader(RegularFile.OpenRead(path));
        char[] text = new char[MaxCharacters];
        return new string(text, 0, reader.ReadBlock(text, 0, MaxCharacters));
    }
}
