using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading;

/// <summary>The end of files of lines that are appended to.</summary>
internal static class LineEnd
{
    /// <summary>Whether a file ends in a line without a line feed.</summary>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static bool IsMissing(string path)
    {
        using FileStream file = InputFile.OpenRead(path);
        if (file.Length == 0)
        {
            return false;
        }

        file.Seek(-1, SeekOrigin.End);
        return file.ReadByte() != '\n';
    }
}
