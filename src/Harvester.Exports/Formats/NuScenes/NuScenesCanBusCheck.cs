using System.Text.Json;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>Checks the files of the CAN bus of a scene: all exist, and the messages are in the order of their time.</summary>
internal static class NuScenesCanBusCheck
{
    private const string Begin = "[";
    private const string End = "]";
    private const string Empty = "[]";

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset, string scene)
    {
        foreach (string kind in NuScenesCanBus.FileKinds)
        {
            string name = $"{NuScenesCanBus.Folder}/{scene}_{kind}.json";
            if (!dataset.Has(name))
            {
                yield return new SessionProblem(name, null, "it is missing.");
            }
            else if (NuScenesCanBus.Kinds.ContainsKey(kind) && FirstProblem(dataset, name) is { } problem)
            {
                yield return problem;
            }
        }
    }

    private static SessionProblem? FirstProblem(DatasetContent dataset, string name)
    {
        long last = long.MinValue;
        string text = "";
        foreach ((int number, string line) in dataset.Lines(name))
        {
            text = line;
            if (line is Begin or End or Empty)
            {
                continue;
            }

            try
            {
                using JsonDocument document = JsonInput.Parse(line.EndsWith(',') ? line[..^1] : line);
                long time = new JsonFields(document.RootElement).LongInteger("utime");
                if (time <= last)
                {
                    return new SessionProblem(name, number, "its utime is not after that of the message before.");
                }

                last = time;
            }
            catch (Exception e) when (e is JsonException or DatasetFormatException)
            {
                return new SessionProblem(name, number, JsonFault.InText(e));
            }
        }

        return text is End or Empty ? null : new SessionProblem(name, null, "it is cut off.");
    }
}
