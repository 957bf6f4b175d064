using System;
using System.IO;
using System.Text.Json;
using System.Text.Unicode;
using Harvester.Datasets.Files;

namespace Harvester.Datasets.Json;

/// <summary>Parses JSON of strangers: no document that is too large, no name twice in one object, no text that is not Unicode.</summary>
public static class JsonInput
{
    private static readonly JsonDocumentOptions Options = new() { AllowDuplicateProperties = false };

    /// <summary>Parses a text.</summary>
    /// <exception cref="JsonException">It is not JSON.</exception>
    /// <exception cref="DatasetFormatException">It is too large, has a name twice, or a text that is not Unicode.</exception>
    public static JsonDocument Parse(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        return text.Length > InputFile.MaxDocumentBytes
            ? throw new DatasetFormatException(
                FormattableString.Invariant($"it has more than {InputFile.MaxDocumentBytes} characters; no such document has."))
            : Checked(() => JsonDocument.Parse(text, Options), text.Contains("\\u", StringComparison.Ordinal));
    }

    /// <summary>Parses bytes in UTF-8.</summary>
    /// <exception cref="JsonException">They are not JSON.</exception>
    /// <exception cref="DatasetFormatException">They are not UTF-8, have a name twice, or a text that is not Unicode.</exception>
    public static JsonDocument Parse(ReadOnlyMemory<byte> bytes) => Utf8.IsValid(bytes.Span)
        ? Checked(() => JsonDocument.Parse(bytes, Options), bytes.Span.IndexOf("\\u"u8) >= 0)
        : throw new DatasetFormatException("it is not UTF-8.");

    /// <summary>Parses a file.</summary>
    /// <exception cref="JsonException">It is not JSON.</exception>
    /// <exception cref="DatasetFormatException">As of <see cref="Parse(ReadOnlyMemory{byte})"/>, or it is too large; the message speaks of
    /// the file as "it".</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
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
            throw new DatasetFormatException("a text in it has half a surrogate pair, which is no character.", e);
        }
        catch (JsonException e) when (e.BytePositionInLine is null)
        {
            throw new DatasetFormatException("an object in it has a field twice.", e);
        }
    }

    // Texts are decoded when they are asked for, and that is where they fail.
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
