using Harvester.Sessions.Text;

namespace Harvester.Sessions.Scenarios;

/// <summary>What a session keeps of the scenario that was staged in it: what was intended, and when. Labels say what happened.</summary>
/// <param name="Scenario">The scenario, with the values of its parameters.</param>
/// <param name="Seed">The seed from which these were drawn.</param>
/// <param name="Handles">The handles of the actors in the game, by id.</param>
/// <param name="Log">What it did, in order.</param>
/// <param name="Outcome">Why it was over; null if the session ended before it.</param>
/// <param name="Touched">The actors that the ego touched.</param>
public sealed record ScenarioRecord(
    Scenario Scenario,
    int Seed,
    IReadOnlyDictionary<string, int> Handles,
    IReadOnlyList<ScenarioLogEntry> Log,
    string? Outcome,
    IReadOnlyList<string> Touched
)
{
    /// <summary>Name of the file in a session.</summary>
    public const string FileName = "scenario.json";

    /// <summary>The content of the file.</summary>
    public string ToJson()
    {
        var json = new JsonText(indented: true);
        json.BeginObject().Key("seed").Integer(Seed).Key("outcome").String(Outcome).Key("actors").BeginArray();
        foreach (KeyValuePair<string, int> actor in Handles)
        {
            json.BeginObject().Key("id").String(actor.Key).Key("handle").Integer(actor.Value);
            json.Key("touched").Boolean(Touched.Contains(actor.Key)).EndObject();
        }

        json.EndArray().Key("events").BeginArray();
        foreach (ScenarioLogEntry entry in Log)
        {
            json.BeginObject().Key("event").String(entry.Event).Key("state").String(entry.HasEnded ? "ended" : "begun");
            json.Key("gameFrame").Integer(entry.GameFrame).Key("seconds").Number(entry.Seconds, 3).EndObject();
        }

        json.EndArray().Key("scenario");
        ScenarioJson.Append(json, Scenario);
        return json.EndObject() + "\n";
    }
}
