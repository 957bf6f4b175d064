using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;

namespace Harvester.Capture.Storage;

/// <summary>What a session directory already holds, as far as going on with it needs to know.</summary>
/// <param name="Header">The text of session.json; null when there is none.</param>
/// <param name="Frames">Frames with a label line.</param>
/// <param name="GreatestObjectId">The greatest object number given; 0 when there is none.</param>
internal sealed record SessionContent(string? Header, int Frames, int GreatestObjectId)
{
    // Only labels have an id followed by a class: names are written with their quotation marks escaped.
    private static readonly Regex ObjectId = new("\"id\":([0-9]+),\"class\"", RegexOptions.CultureInvariant);

    public static SessionContent Nothing { get; } = new(null, 0, 0);

    /// <summary>Reads a directory; a last line that was cut off is cut away, so that the next one starts a line.</summary>
    public static SessionContent Read(string directory)
    {
        string header = Path.Combine(directory, SessionDirectory.Header);
        string labels = Path.Combine(directory, SessionDirectory.Labels);
        int frames = 0;
        int greatestId = 0;
        if (File.Exists(labels))
        {
            CutAfterLastLine(labels);
            foreach (string line in File.ReadLines(labels, Encoding.UTF8))
            {
                frames++;
                greatestId = ObjectId.Matches(line).Cast<Match>()
                    .Select(match => int.Parse(match.Groups[1].Value, CultureInfo.InvariantCulture))
                    .Append(greatestId).Max();
            }
        }

        return new SessionContent(File.Exists(header) ? File.ReadAllText(header, Encoding.UTF8) : null, frames, greatestId);
    }

    /// <summary>Whether a session with this header can be continued under another: both say the same up to the start.</summary>
    public bool IsContinuedBy(string header) => Header is null || Settings(Header) == Settings(header);

    private static string Settings(string header)
    {
        int end = header.IndexOf(SessionJson.RunsBegin, StringComparison.Ordinal);
        return end < 0 ? header : header.Substring(0, end);
    }

    private static void CutAfterLastLine(string file)
    {
        using var stream = new FileStream(file, FileMode.Open, FileAccess.ReadWrite, FileShare.Read);
        long end = stream.Length;
        for (; end > 0; end--)
        {
            stream.Position = end - 1;
            if (stream.ReadByte() == '\n')
            {
                break;
            }
        }

        if (end < stream.Length)
        {
            stream.SetLength(end);
        }
    }
}
