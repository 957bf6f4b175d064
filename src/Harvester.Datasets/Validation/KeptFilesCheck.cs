using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenarios;

namespace Harvester.Datasets.Validation;

/// <summary>Checks that the roads, the table of faces and the record of a scenario can be read, if they exist.</summary>
internal static class KeptFilesCheck
{
    public static IEnumerable<SessionProblem> Problems(SessionReader session)
    {
        (string Name, Func<SessionReader, object?> Read)[] files =
        [
            (FramePaths.Roads, KeptFiles.ReadRoads),
            (FramePaths.Faces, KeptFiles.ReadFaces),
            (ScenarioRecord.FileName, KeptFiles.ReadScenario),
        ];
        foreach ((string name, Func<SessionReader, object?> read) in files)
        {
            if (Damage(session, read) is { } damage)
            {
                yield return new SessionProblem(name, null, damage);
            }
        }
    }

    private static string? Damage(SessionReader session, Func<SessionReader, object?> read)
    {
        try
        {
            read(session);
            return null;
        }
        catch (DatasetFormatException e)
        {
            return e.Message;
        }
    }
}
