using System.Security.Cryptography;
using System.Text;

namespace Harvester.Sessions.Files;

/// <summary>Size and checksum of a file, or of a line without its line feed.</summary>
/// <param name="Bytes">Size, bytes.</param>
/// <param name="Sha256">SHA-256, 64 hexadecimal digits in lower case.</param>
public readonly record struct FileDigest(long Bytes, string Sha256)
{
    private static readonly UTF8Encoding Utf8 = new(encoderShouldEmitUTF8Identifier: false);

    /// <summary>The digest of a text as UTF-8 without a byte order mark.</summary>
    public static FileDigest Of(string text)
    {
        byte[] bytes = Utf8.GetBytes(text);
        return Of(bytes, bytes.Length);
    }

    /// <summary>The digest of bytes.</summary>
    /// <param name="bytes">The bytes.</param>
    /// <param name="count">How many of them count.</param>
    public static FileDigest Of(byte[] bytes, int count)
    {
        using HashAlgorithm sha256 = SHA256.Create();
        return new FileDigest(count, Hex(sha256.ComputeHash(bytes, 0, count)));
    }

    /// <summary>The digest of a file.</summary>
    /// <exception cref="IOException">It cannot be read, or is a pipe, a socket or a device.</exception>
    public static FileDigest OfFile(string path)
    {
        using FileStream file = RegularFile.OpenRead(path);
        using HashAlgorithm sha256 = SHA256.Create();
        byte[] hash = sha256.ComputeHash(file);
        return new FileDigest(file.Position, Hex(hash));
    }

    internal static string Hex(byte[] hash)
    {
        const string digits = "0123456789abcdef";
        var text = new StringBuilder(2 * hash.Length);
        foreach (byte each in hash)
        {
            text.Append(digits[each >> 4]).Append(digits[each & 15]);
        }

        return text.ToString();
    }
}
