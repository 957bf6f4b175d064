using Harvester.Sessions.Files;
using Harvester.Sessions.Text;

namespace Harvester.Play.Plans;

/// <summary>The file attempt.json of a plan's output in the game: the attempt that is under way.</summary>
internal static class AttemptFile
{
    private const string Name = "attempt.json";
    private const int MaxCharacters = 4096;

    /// <summary>Notes an attempt; it is on the disk when this returns.</summary>
    public static void Write(string folder, string trial, int attempt) =>
        AtomicFile.Write(
            Path.Combine(folder, Name),
            new JsonText().BeginObject().Key("trial").String(trial).Key("attempt").Integer(attempt).EndObject() + "\n"
        );

    /// <summary>The attempt; null for none, or for a file of something else.</summary>
    public static (string Trial, int Attempt)? Read(string folder)
    {
        string path = Path.Combine(folder, Name);
        if (!File.Exists(path))
        {
            return null;
        }

        using var reader = new StreamReader(RegularFile.OpenRead(path));
        char[] text = new char[MaxCharacters];
        try
        {
            CheckedJson fields = CheckedJson.Parse(new string(text, 0, reader.ReadBlock(text, 0, text.Length)), "an attempt at a trial");
            return (fields.Text("trial"), fields.Whole("attempt", 1, int.MaxValue));
        }
        catch (FormatException)
        {
            return null;
        }
    }

    /// <summary>Notes that no attempt is under way.</summary>
    public static void Delete(string folder) => File.Delete(Path.Combine(folder, Name));
}
