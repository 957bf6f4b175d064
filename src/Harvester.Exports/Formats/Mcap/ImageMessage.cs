using Foxglove;
using Google.Protobuf;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>Reads messages of the type foxglove.CompressedImage.</summary>
internal static class ImageMessage
{
    /// <summary>Checks that the image of a message is whole.</summary>
    /// <param name="bytes">Bytes that contain the message.</param>
    /// <param name="start">Where it begins.</param>
    /// <param name="length">Number of its bytes.</param>
    /// <exception cref="DatasetFormatException">The message has no image, or a damaged one; the message refers to it as "it".</exception>
    public static void Check(byte[] bytes, int start, int length)
    {
        CompressedImage message;
        try
        {
            message = CompressedImage.Parser.ParseFrom(bytes, start, length);
        }
        catch (InvalidProtocolBufferException e)
        {
            throw new DatasetFormatException("it is not a protobuf message.", e);
        }

        if (message.Data.IsEmpty)
        {
            throw new DatasetFormatException("it has no image.");
        }

        ImageHeader.Read(new MemoryStream(message.Data.ToByteArray()));
    }
}
