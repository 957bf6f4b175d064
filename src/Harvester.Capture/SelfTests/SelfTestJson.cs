using Harvester.Sessions.Text;

namespace Harvester.Capture.SelfTests;

/// <summary>Writes selftest.json, as docs/mod.md describes it.</summary>
public static class SelfTestJson
{
    /// <summary>Name of the file.</summary>
    public const string FileName = "selftest.json";

    /// <summary>The version of the format.</summary>
    public const int FormatVersion = 1;

    /// <summary>The text of the file.</summary>
    /// <param name="tool">Name and version of the writer.</param>
    /// <param name="game">Name and version of the game.</param>
    /// <param name="test">A self-test that is over.</param>
    /// <param name="changes">The settings that were changed, as name and value.</param>
    public static string Text(string tool, string game, SelfTest test, IReadOnlyList<KeyValuePair<string, string>> changes)
    {
        var json = new JsonText(indented: true);
        json.BeginObject()
            .Key("formatVersion")
            .Integer(FormatVersion)
            .Key("kind")
            .String("selfTest")
            .Key("tool")
            .String(tool)
            .Key("game")
            .String(game)
            .Key("isComplete")
            .Boolean(test.Phase == SelfTestPhase.Done)
            .Key("checks")
            .BeginArray();
        foreach (SelfTestLine line in test.Lines)
        {
            json.BeginObject()
                .Key("check")
                .String(line.Check)
                .Key("verdict")
                .String(JsonName.Of(line.Verdict))
                .Key("finding")
                .String(line.Sentence)
                .EndObject();
        }

        json.EndArray().Key("changedSettings").BeginObject();
        foreach (KeyValuePair<string, string> change in changes)
        {
            json.Key(change.Key).String(change.Value);
        }

        json.EndObject().Key("pictures").BeginArray();
        foreach (string picture in test.Pictures.Select(picture => picture.Name + ".png"))
        {
            json.String(picture);
        }

        return json.EndArray().EndObject() + "\n";
    }
}
