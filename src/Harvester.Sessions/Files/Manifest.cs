using System.Globalization;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Files;

/// <summary>
/// Writes the lines of manifest.jsonl: size and SHA-256 of every file of a session or dataset. Each line ends with a checksum of itself,
/// so that a damaged line is not taken for a damaged file. Fields: docs/dataset-format.md.
/// </summary>
public static class Manifest
{
    /// <summary>Name of the file.</summary>
    public const string FileName = "manifest.jsonl";

    private const string FrameBegin = "{\"frame\":";
    private const string BytesBegin = ",\"bytes\":";
    private const string CheckBegin = ",\"check\":\"";
    private const int CheckDigits = 16;

    /// <summary>The line of a frame, without its line feed.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="label">Digest of its label line without the line feed.</param>
    /// <param name="files">Its files: path within the session, with forward slashes, and digest.</param>
    public static string FrameLine(int frame, FileDigest label, IEnumerable<KeyValuePair<string, FileDigest>> files)
    {
        JsonText json = new JsonText().BeginObject().Key("frame").Integer(frame).Key("label");
        Append(json.BeginObject(), label).EndObject().Key("files").BeginArray();
        foreach (KeyValuePair<string, FileDigest> file in files)
        {
            Append(json.BeginObject().Key("path").String(file.Key), file.Value).EndObject();
        }

        return Checked(json.EndArray().EndObject());
    }

    /// <summary>The line of a file that belongs to no single frame, without its line feed.</summary>
    /// <param name="path">Its path within the session, with forward slashes.</param>
    /// <param name="digest">Its digest.</param>
    public static string FileLine(string path, FileDigest digest) =>
        Checked(Append(new JsonText().BeginObject().Key("path").String(path), digest).EndObject());

    /// <summary>Whether a line is as it was written, by the checksum at its end.</summary>
    public static bool IsIntact(string line)
    {
        int end = line.Length - CheckBegin.Length - CheckDigits - 2;
        return end > 0 && line == Checked(line.Substring(0, end) + "}");
    }

    /// <summary>The frame that an intact line is about; null for the line of another file.</summary>
    public static int? FrameOf(string line)
    {
        int end = line.IndexOf(',');
        return
            line.StartsWith(FrameBegin, StringComparison.Ordinal)
            && end > 0
            && int.TryParse(
                line.Substring(FrameBegin.Length, end - FrameBegin.Length),
                NumberStyles.None,
                CultureInfo.InvariantCulture,
                out int frame
            )
            ? frame
            : null;
    }

    /// <summary>The text in which an intact line of a file names its path, escaped as in JSON.</summary>
    internal static string PathOf(string line) => line.Substring(0, line.IndexOf(BytesBegin, StringComparison.Ordinal));

    private static string Checked(JsonText json) => Checked(json.ToString());

    private static string Checked(string json)
    {
        string text = json.Substring(0, json.Length - 1);
        return text + CheckBegin + FileDigest.Of(text).Sha256.Substring(0, CheckDigits) + "\"}";
    }

    private static JsonText Append(JsonText json, FileDigest digest) =>
        json.Key("bytes").Integer(digest.Bytes).Key("sha256").String(digest.Sha256);
}
