using System.Xml;

namespace Harvester.Play.Settings;

/// <summary>The game's settings.xml in the player's documents.</summary>
public static class GraphicsSettingsFile
{
    private const int MaxBytes = 1024 * 1024;

    /// <summary>The path of the file.</summary>
    /// <param name="isEnhanced">Whether the game is Enhanced, which has a folder of its own.</param>
    public static string PathOf(bool isEnhanced) =>
        Path.Combine(
            Environment.GetFolderPath(Environment.SpecialFolder.MyDocuments),
            "Rockstar Games",
            isEnhanced ? "GTAV Enhanced" : "GTA V",
            "settings.xml"
        );

    /// <summary>Reads the file; of a longer one at most 1 MiB and a byte.</summary>
    /// <param name="path">The file, which the game may have open.</param>
    /// <exception cref="IOException">It is missing, longer than 1 MiB or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">Permission denied, or it is a folder.</exception>
    /// <exception cref="XmlException">It is not well-formed, or has a document type; the message is one line.</exception>
    public static GraphicsSettings Read(string path)
    {
        byte[] bytes = new byte[MaxBytes + 1];
        int length = 0;
        using (var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete))
        {
            int read;
            while ((read = file.Read(bytes, length, bytes.Length - length)) > 0)
            {
                length += read;
            }
        }

        if (length > MaxBytes)
        {
            throw new IOException("the file is longer than 1 MiB.");
        }

        using var text = new StreamReader(new MemoryStream(bytes, 0, length));
        try
        {
            return GraphicsSettings.Parse(text);
        }
        catch (XmlException exception)
        {
            // The parser quotes what it found, line feeds included.
            throw new XmlException(exception.Message.Replace('\r', ' ').Replace('\n', ' '), exception);
        }
    }
}
