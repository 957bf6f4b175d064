using System.Text.Json;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenarios;

namespace Harvester.Runs.Harvesting;

/// <summary>What the record of the scenario in a base session says about its actors and events.</summary>
/// <param name="Actors">The handles of the actors in the game, by id.</param>
/// <param name="Begun">The game frames in which events began, by id; those that did not begin are absent.</param>
internal sealed record StagedBase(IReadOnlyDictionary<string, int> Actors, IReadOnlyDictionary<string, long> Begun)
{
    /// <summary>Reads the record of a session.</summary>
    /// <param name="folder">The session.</param>
    /// <exception cref="DatasetFormatException">It is missing or invalid.</exception>
    public static StagedBase Read(string folder)
    {
        string path = Path.Combine(folder, ScenarioRecord.FileName);
        try
        {
            using JsonDocument document = JsonInput.Read(path);
            var fields = new JsonFields(document.RootElement);
            Dictionary<string, int> actors = new(StringComparer.Ordinal);
            Dictionary<string, long> begun = new(StringComparer.Ordinal);
            foreach (JsonFields actor in fields.List("actors"))
            {
                actors.TryAdd(actor.Text("id"), actor.Integer("handle"));
            }

            foreach (JsonFields entry in fields.List("events").Where(entry => entry.Text("state") == "begun"))
            {
                begun.TryAdd(entry.Text("event"), entry.LongInteger("gameFrame"));
            }

            return new StagedBase(actors, begun);
        }
        catch (Exception e) when (e is JsonException or DatasetFormatException)
        {
            throw new DatasetFormatException($"{path}: {e.Message}", e);
        }
        catch (FileNotFoundException e)
        {
            throw new DatasetFormatException($"{path} is missing.", e);
        }
    }
}
