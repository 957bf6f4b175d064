using System.Text;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Files;

/// <summary>Text files of lines that appear whole or not at all.</summary>
internal static class AtomicLines
{
    private static readonly UTF8Encoding Utf8 = new(encoderShouldEmitUTF8Identifier: false);

    /// <summary>Writes a file, in place of an older one.</summary>
    /// <param name="path">The file; its folder must exist.</param>
    /// <param name="isDurable">Whether the file must survive a loss of power once this returns.</param>
    /// <param name="write">Writes the lines.</param>
    /// <exception cref="IOException">The file cannot be written; an older one is unchanged.</exception>
    public static void Write(string path, bool isDurable, Action<TextWriter> write) =>
        AtomicFile.Write(
            path,
            stream =>
            {
                using var lines = new StreamWriter(stream, Utf8, leaveOpen: true) { NewLine = "\n" };
                write(lines);
            },
            isDurable
        );
}
