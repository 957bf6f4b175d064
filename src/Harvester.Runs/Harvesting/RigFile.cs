using Harvester.Runs.Faults;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Rigs;

namespace Harvester.Runs.Harvesting;

/// <summary>Reads the files of rigs.</summary>
public static class RigFile
{
    /// <summary>Reads the file of a rig.</summary>
    /// <param name="path">The file.</param>
    /// <param name="masks">Whether its views have masks.</param>
    /// <param name="depth">Whether its views have depth maps.</param>
    /// <exception cref="UsageException">The rig takes too long.</exception>
    /// <exception cref="DatasetFormatException">The file is not a rig.</exception>
    public static Rig Read(string path, bool masks, bool depth)
    {
        Rig rig;
        try
        {
            rig = RigParser.Parse(InputFile.ReadAllText(path));
        }
        catch (FormatException e)
        {
            throw new DatasetFormatException($"'{path}' is not a rig: {e.Message.TrimEnd('.')}.", e);
        }

        return RigBudget.ProblemOf(rig, RigBudget.SecondsPerMoment(rig, masks, depth)) is { } problem
            ? throw new UsageException(problem)
            : rig;
    }
}
