using Harvester.Sessions.Text;

namespace Harvester.Sessions.SelfTests;

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
    /// <param name="isComplete">Whether all checks were made.</param>
    /// <param name="lines">The results of the checks.</param>
    /// <param name="changes">The settings that were changed, as name and value.</param>
    /// <param name="pictures">The names of the pictures beside it.</param>
    /// <exception cref="ArgumentNullException">A list is null.</exception>
    public static string Text(
        string tool,
        string game,
        bool isComplete,
        IReadOnlyList<SelfTestLine> lines,
        IReadOnlyList<KeyValuePair<string, string>> changes,
        IEnumerable<string> pictures
    )
    {
        if (lines is null || changes is null || pictures is null)
        {
            throw new ArgumentNullException(
                lines is null ? nameof(lines)
                : changes is null ? nameof(changes)
                : nameof(pictures)
            );
        }

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
            .Boolean(isComplete)
            .Key("checks")
            .BeginArray();
        foreach (SelfTestLine line in lines)
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
        foreach (string picture in pictures)
        {
            json.String(picture);
        }

        return json.EndArray().EndObject() + "\n";
    }
}
