using System.Text;
using Harvester.Sessions.Files;

namespace Harvester.Sessions.Reading.Files;

/// <summary>
/// Reads untrusted files: regular files only, with limits on what is held in memory, so that no input takes more than 1 GB.
/// docs/untrusted-input.md lists the limits.
/// </summary>
public static class InputFile
{
    /// <summary>Largest file that is held in memory, bytes. A JSON document takes up to 20 times as much.</summary>
    public const int MaxDocumentBytes = 16 << 20;

    /// <summary>Largest image, bytes; the largest bitmap has about 200 MB.</summary>
    public const int MaxPictureBytes = 256 << 20;

    /// <summary>Longest line of a text, characters; a label line with thousands of objects has fewer.</summary>
    public const int MaxLineCharacters = 8 << 20;

    /// <summary>Opens a file for reading.</summary>
    /// <exception cref="IOException">The file cannot be read, or is a pipe, socket or device.</exception>
    public static FileStream OpenRead(string path) => RegularFile.OpenRead(path);

    /// <summary>Opens a text whose lines have at most <see cref="MaxLineCharacters"/> characters.</summary>
    /// <exception cref="IOException">The file cannot be read, or is a pipe, socket or device.</exception>
    public static TextReader OpenText(string path) => Limited(new StreamReader(OpenRead(path), Encoding.UTF8), Path.GetFileName(path));

    /// <summary>A text whose ReadLine throws if a line is too long.</summary>
    /// <param name="text">The text.</param>
    /// <param name="name">Name in messages.</param>
    /// <param name="maxLineCharacters">Longest line, characters.</param>
    public static TextReader Limited(TextReader text, string name, int maxLineCharacters = MaxLineCharacters) =>
        new LimitedTextReader(text, name, maxLineCharacters);

    /// <summary>The lines of a text, one by one.</summary>
    /// <param name="path">The file.</param>
    /// <param name="maxLineCharacters">Longest line, characters.</param>
    /// <exception cref="DatasetFormatException">A line is longer.</exception>
    /// <exception cref="IOException">The file cannot be read, or is a pipe, socket or device.</exception>
    public static IEnumerable<string> ReadLines(string path, int maxLineCharacters = MaxLineCharacters)
    {
        using TextReader text = Limited(new StreamReader(OpenRead(path), Encoding.UTF8), Path.GetFileName(path), maxLineCharacters);
        while (text.ReadLine() is { } line)
        {
            yield return line;
        }
    }

    /// <summary>All bytes of a file.</summary>
    /// <param name="path">The file.</param>
    /// <param name="maxBytes">Largest size, bytes.</param>
    /// <exception cref="DatasetFormatException">The file is larger.</exception>
    /// <exception cref="IOException">The file cannot be read, or is a pipe, socket or device.</exception>
    public static byte[] ReadAllBytes(string path, int maxBytes = MaxDocumentBytes)
    {
        using FileStream file = OpenRead(path);
        if (file.Length > maxBytes)
        {
            throw new DatasetFormatException($"'{path}' is larger than {maxBytes} bytes, the limit.");
        }

        byte[] bytes = new byte[file.Length];
        file.ReadExactly(bytes);
        return bytes;
    }

    /// <summary>The content of a text file of at most <see cref="MaxDocumentBytes"/>.</summary>
    /// <exception cref="DatasetFormatException">The file is larger.</exception>
    /// <exception cref="IOException">The file cannot be read, or is a pipe, socket or device.</exception>
    public static string ReadAllText(string path)
    {
        using var reader = new StreamReader(new MemoryStream(ReadAllBytes(path)), Encoding.UTF8);
        return reader.ReadToEnd();
    }
}
