using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenarios;

namespace Harvester.Runs.Plans;

/// <summary>A plan file and the rigs that it names.</summary>
/// <param name="Plan">The plan.</param>
/// <param name="Text">The text of the file.</param>
/// <param name="Rigs">The rigs by the name of their camera.</param>
public sealed record PlanFile(Plan Plan, string Text, IReadOnlyDictionary<string, Rig> Rigs)
{
    /// <summary>The scenarios by the path that the plan names.</summary>
    public IReadOnlyDictionary<string, ScenarioTemplate> Scenarios { get; init; } = new Dictionary<string, ScenarioTemplate>();

    /// <summary>Reads a plan that has no problem.</summary>
    /// <exception cref="DatasetFormatException">The plan or a rig has a problem; the first is named.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static PlanFile Read(string path)
    {
        List<string> problems = ProblemsOf(path, out PlanFile? file);
        return file
            ?? throw new DatasetFormatException(
                $"'{path}': {problems[0]}" + (problems.Count > 1 ? $" {problems.Count - 1} more: harvester plan check lists all." : "")
            );
    }

    /// <summary>All problems of a plan file, one line each; empty if it can run.</summary>
    /// <param name="path">The file.</param>
    /// <param name="file">What it holds; null if it has problems.</param>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static List<string> ProblemsOf(string path, out PlanFile? file)
    {
        string text = InputFile.ReadAllText(path);
        PlanReading reading = PlanParser.Read(text);
        List<string> problems = [.. reading.Problems];
        var rigs = new Dictionary<string, Rig>(StringComparer.Ordinal);
        foreach (PlanCamera camera in reading.Plan?.Cameras ?? [])
        {
            if (camera.RigFile is { } rig)
            {
                try
                {
                    string beside = Path.Combine(Path.GetDirectoryName(Path.GetFullPath(path))!, rig);
                    rigs.Add(camera.Name, RigFile.Read(beside, reading.Plan!.Masks != PlanMasks.Off, depth: false));
                }
                catch (Exception e) when (e is DatasetFormatException or UsageException)
                {
                    problems.Add($"rig of camera '{camera.Name}': {e.Message}");
                }
                catch (Exception e) when (e is IOException or UnauthorizedAccessException)
                {
                    problems.Add($"rig of camera '{camera.Name}': '{rig}' cannot be read beside the plan.");
                }
            }
        }

        Dictionary<string, ScenarioTemplate> scenarios = ScenariosOf(path, reading.Plan, problems);
        file = problems.Count == 0 ? new PlanFile(reading.Plan!, text, rigs) { Scenarios = scenarios } : null;
        return problems;
    }

    private static Dictionary<string, ScenarioTemplate> ScenariosOf(string path, Plan? plan, List<string> problems)
    {
        var scenarios = new Dictionary<string, ScenarioTemplate>(StringComparer.Ordinal);
        foreach (string file in (plan?.Places ?? []).Select(place => place.Scenario).OfType<string>().Distinct(StringComparer.Ordinal))
        {
            try
            {
                string beside = Path.Combine(Path.GetDirectoryName(Path.GetFullPath(path))!, file);
                ScenarioReading reading = ScenarioParser.Read(InputFile.ReadAllText(beside));
                problems.AddRange(reading.Problems.Select(problem => $"scenario '{file}': {problem}"));
                if (reading.Template is { } template)
                {
                    scenarios.Add(file, template);
                }
            }
            catch (Exception e) when (e is DatasetFormatException)
            {
                problems.Add($"scenario '{file}': {e.Message}");
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                problems.Add($"scenario '{file}' cannot be read beside the plan.");
            }
        }

        return scenarios;
    }
}
