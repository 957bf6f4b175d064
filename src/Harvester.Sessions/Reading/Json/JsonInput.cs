using System.Text.Json;
using System.Text.Unicode;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading.Json;

/// <summary>
/// Parses untrusted JSON. Rejects documents that are too large, duplicate names in an object, and strings that are not valid Unicode.
/// </summary>
public static class JsonInput
{
    private static readonly JsonDocumentOptions Options = new() { AllowDuplicateProperties = false };

    /// <summary>Parses a string.</summary>
    /// <exception cref="JsonException">The text is not valid JSON.</exception>
    /// <exception cref="DatasetFormatException">The text is too large, or has a duplicate name or a string that is not valid
    /// Unicode.</exception>
    public static JsonDocument Parse(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        return text.Length > InputFile.MaxDocumentBytes
            ? throw new DatasetFormatException(
                FormattableString.Invariant($"it has more than {InputFile.MaxDocumentBytes} characters, the limit.")
            )
            : Checked(() => JsonDocument.Parse(text, Options), text.Contains("\\u", StringComparison.Ordinal));
    }

    /// <summary>Parses bytes in UTF-8.</summary>
    /// <exception cref="JsonException">The bytes are not valid JSON.</exception>
    /// <exception cref="DatasetFormatException">The bytes are not UTF-8, or have a duplicate name or a string that is not valid
    /// Unicode.</exception>
    public static JsonDocument Parse(ReadOnlyMemory<byte> bytes) =>
        Utf8.IsValid(bytes.Span)
            ? Checked(() => JsonDocument.Parse(bytes, Options), bytes.Span.IndexOf("\\u"u8) >= 0)
            : throw new DatasetFormatException("it is not UTF-8.");

    /// <summary>Parses a file.</summary>
    /// <exception cref="JsonException">The file is not valid JSON.</exception>
    /// <exception cref="DatasetFormatException">As for <see cref="Parse(ReadOnlyMemory{byte})"/>, or the file is too large; the message
    /// refers to the file as "it".</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static JsonDocument Read(string path) => Parse(InputFile.ReadAllBytes(path));

    private static JsonDocument Checked(Func<JsonDocument> parse, bool hasEscapes)
    {
        JsonDocument? document = null;
        try
        {
            document = parse();
            if (hasEscapes)
            {
                Visit(document.RootElement);
            }

            return document;
        }
        catch (InvalidOperationException e)
        {
            document?.Dispose();
            throw new DatasetFormatException("a string in it has an unpaired surrogate, which is not valid Unicode.", e);
        }
        catch (JsonException e) when (e.BytePositionInLine is null)
        {
            throw new DatasetFormatException("an object in it has a duplicate field.", e);
        }
    }

    // Strings are decoded when they are read; an invalid one throws then.
    private static void Visit(JsonElement element)
    {
        switch (element.ValueKind)
        {
            case JsonValueKind.String:
                _ = element.GetString();
                break;
            case JsonValueKind.Array:
                foreach (JsonElement item in element.EnumerateArray())
                {
                    Visit(item);
                }

                break;
            case JsonValueKind.Object:
                foreach (JsonProperty member in element.EnumerateObject())
                {
                    _ = member.Name;
                    Visit(member.Value);
                }

                break;
        }
    }
}
