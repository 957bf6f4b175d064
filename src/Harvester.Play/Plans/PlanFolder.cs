using Harvester.Sessions.Files;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenarios;

namespace Harvester.Play.Plans;

/// <summary>
/// The folder of a plan's output in the game, locked: a copy of the plan and its rigs, the status of its trials, and their sessions. While
/// an attempt is under way, a file names it: if the file is there when the folder is opened, the game has ended during the attempt.
/// </summary>
public sealed class PlanFolder : IDisposable
{
    private const string Rigs = "rigs";
    private const string Scenarios = "scenarios";
    private const string EndedReason = "The game ended during the attempt.";
    private readonly PlanResults _results;
    private readonly IReadOnlyDictionary<string, PlanRig> _rigs;
    private readonly IReadOnlyDictionary<string, PlanScenario> _scenarios;
    private readonly object _gate = new();
    private bool _isReleased;

    private PlanFolder(
        PlanResults results,
        Plan plan,
        IReadOnlyDictionary<string, PlanRig> rigs,
        IReadOnlyDictionary<string, PlanScenario> scenarios
    )
    {
        (_results, Plan, _rigs, _scenarios) = (results, plan, rigs, scenarios);
        Trials = TrialList.Of(plan, plan.Places);
    }

    /// <summary>The folder.</summary>
    public string Folder => _results.Folder;

    /// <summary>The plan.</summary>
    public Plan Plan { get; }

    /// <summary>Its trials, in their order.</summary>
    public IReadOnlyList<Trial> Trials { get; }

    /// <summary>How they ended.</summary>
    public PlanStatus Status => _results.Status;

    /// <summary>The attempt during which the game ended before the folder was opened; null if it did not.</summary>
    public TrialResult? Ended { get; private set; }

    /// <summary>The trials that need an attempt, in their order.</summary>
    public IEnumerable<Trial> Left => _results.Left(Trials);

    /// <summary>The first trial that needs an attempt; null if none does.</summary>
    public Trial? Next => Left.FirstOrDefault();

    /// <summary>Reads a plan, and opens its folder or makes it.</summary>
    /// <param name="file">The plan file.</param>
    /// <param name="root">The folder with the folders of all plans.</param>
    /// <exception cref="FormatException">The plan has a problem, or the folder has results of another plan of that name.</exception>
    /// <exception cref="IOException">A file cannot be read or written.</exception>
    /// <exception cref="UnauthorizedAccessException">A file cannot be read or written.</exception>
    /// <exception cref="FolderLockedException">Another program runs the plan.</exception>
    public static PlanFolder Open(string file, string root)
    {
        string text = PlanResults.ReadText(file);
        PlanReading reading = PlanParser.Read(text);
        string? problem = reading.Plan is { } read ? ProblemOf(read) : reading.Problems[0];
        if (problem is not null)
        {
            throw new FormatException($"{Path.GetFileName(file)}: {problem}");
        }

        Plan plan = reading.Plan!;
        Dictionary<string, PlanRig> rigs = RigsOf(plan, file);
        Dictionary<string, PlanScenario> scenarios = ScenariosOf(plan, file);
        string folder = Path.Combine(root, plan.Name);
        Directory.CreateDirectory(root);
        var results = new PlanResults(folder, WriterLock.Take(folder));
        try
        {
            Directory.CreateDirectory(results.Trials);
            Directory.CreateDirectory(Path.Combine(folder, Rigs));
            if (scenarios.Count > 0)
            {
                Directory.CreateDirectory(Path.Combine(folder, Scenarios));
            }

            if (
                new[] { (PlanResults.PlanCopy, text) }
                    .Concat(rigs.Select(rig => (Path.Combine(Rigs, rig.Key + ".json"), rig.Value.Text)))
                    .Concat(scenarios.Select(place => (Path.Combine(Scenarios, place.Key + ".json"), place.Value.Text)))
                    .Any(input => !results.Keep(input.Item1, input.Item2))
            )
            {
                throw new FormatException($"{results.OfAnotherPlan} Give the plan another name.");
            }

            results.ReadStatus(Shard.Whole);
            var opened = new PlanFolder(results, plan, rigs, scenarios);
            opened.NoteEnded();
            return opened;
        }
        catch
        {
            results.Dispose();
            throw;
        }
    }

    /// <summary>The folder of a trial's session.</summary>
    public string FolderOf(Trial trial) => _results.FolderOf(trial);

    /// <summary>The rig of a trial's camera; null for a single camera.</summary>
    public Rig? RigOf(Trial trial) =>
        _rigs.TryGetValue((trial ?? throw new ArgumentNullException(nameof(trial))).Camera.Name, out PlanRig rig) ? rig.Rig : null;

    /// <summary>The scenario of a trial, and the seed of its next attempt; null without one.</summary>
    public (ScenarioTemplate Template, int Seed)? ScenarioOf(Trial trial) =>
        _scenarios.TryGetValue((trial ?? throw new ArgumentNullException(nameof(trial))).Place.Name, out PlanScenario staged)
            ? (staged.Template, trial.SeedOf(Plan.Seed, Status.NextAttempt(trial.Id) ?? 1))
            : null;

    /// <summary>
    /// Prepares the next attempt at a trial, and notes on the disk that it is under way. It has no effect once the folder is released.
    /// </summary>
    /// <exception cref="IOException">A folder cannot be moved, or a file not be written.</exception>
    /// <exception cref="UnauthorizedAccessException">A file cannot be written.</exception>
    public void Begin(Trial trial)
    {
        lock (_gate)
        {
            if (!_isReleased)
            {
                _results.SetAside(trial ?? throw new ArgumentNullException(nameof(trial)));
                AttemptFile.Write(Folder, trial.Id, Status.NextAttempt(trial.Id)!.Value);
            }
        }
    }

    /// <summary>Notes how the attempt that is under way has ended. What the last attempt wrote is moved away.</summary>
    /// <exception cref="IOException">A folder cannot be moved, or a file not be written.</exception>
    /// <exception cref="UnauthorizedAccessException">A file cannot be written.</exception>
    public void End(TrialResult result)
    {
        if ((result ?? throw new ArgumentNullException(nameof(result))).State == TrialState.Skipped)
        {
            _results.SetAside(Trials.First(trial => trial.Id == result.Trial));
        }

        Status.Add(result);
        AttemptFile.Delete(Folder);
    }

    /// <summary>Releases the folder. An attempt that is under way does not count.</summary>
    public void Dispose()
    {
        lock (_gate)
        {
            _isReleased = true;
            try
            {
                AttemptFile.Delete(Folder);
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                // The attempt then counts as one that failed.
                return;
            }
            finally
            {
                _results.Dispose();
            }
        }
    }

    private void NoteEnded()
    {
        if (AttemptFile.Read(Folder) is var (id, attempt) && Trials.Any(trial => trial.Id == id) && Status.NextAttempt(id) == attempt)
        {
            Ended = TrialResult.OfFailure(id, attempt, 0, EndedReason);
            End(Ended);
        }
    }

    /// <summary>What the game cannot do of a plan that the simulated game can; null if it can all.</summary>
    private static string? ProblemOf(Plan plan)
    {
        PlanPlace? open = plan.Places.FirstOrDefault(place => place.Start is null);
        return open is null
            ? null
            : $"the place '{open.Name}' needs x and y, or a path: 'harvester plan resolve' chooses places for the game.";
    }

    /// <summary>The scenarios by the name of their place, from files beside the plan.</summary>
    private static Dictionary<string, PlanScenario> ScenariosOf(Plan plan, string file)
    {
        var scenarios = new Dictionary<string, PlanScenario>(StringComparer.Ordinal);
        foreach (PlanPlace place in plan.Places.Where(place => place.Scenario is not null))
        {
            string text;
            try
            {
                text = PlanResults.ReadText(Path.Combine(Path.GetDirectoryName(Path.GetFullPath(file))!, place.Scenario!));
            }
            catch (Exception e) when (e is FormatException or IOException or UnauthorizedAccessException)
            {
                throw new FormatException($"{Path.GetFileName(file)}: the scenario {place.Scenario} cannot be read: {e.Message}", e);
            }

            ScenarioReading reading = ScenarioParser.Read(text);
            scenarios.Add(
                place.Name,
                reading.Template is { } template
                    ? new PlanScenario(template, text)
                    : throw new FormatException($"{Path.GetFileName(file)}: the scenario {place.Scenario}: {reading.Problems[0]}")
            );
        }

        return scenarios;
    }

    /// <summary>The rigs by the name of their camera, from files beside the plan.</summary>
    private static Dictionary<string, PlanRig> RigsOf(Plan plan, string file)
    {
        var rigs = new Dictionary<string, PlanRig>(StringComparer.Ordinal);
        foreach (PlanCamera camera in plan.Cameras.Where(camera => camera.RigFile is not null))
        {
            try
            {
                string text = PlanResults.ReadText(Path.Combine(Path.GetDirectoryName(Path.GetFullPath(file))!, camera.RigFile!));
                rigs.Add(camera.Name, new PlanRig(RigParser.Parse(text), text));
            }
            catch (Exception e) when (e is FormatException or IOException or UnauthorizedAccessException)
            {
                throw new FormatException(
                    $"{Path.GetFileName(file)}: the rig {camera.RigFile} of the camera '{camera.Name}' cannot be used: {e.Message}",
                    e
                );
            }
        }

        return rigs;
    }
}
