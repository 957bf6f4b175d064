using Google.Protobuf;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>Reads messages of the type foxglove.CompressedImage.</summary>
internal static class ImageMessage
{
    /// <summary>Number of the field with the bytes of the image file.</summary>
    public const int DataField = 2;

    /// <summary>Checks that the image of a message is whole.</summary>
    /// <param name="bytes">Bytes that contain the message.</param>
    /// <param name="start">Where it begins.</param>
    /// <param name="length">Number of its bytes.</param>
    /// <exception cref="DatasetFormatException">The message has no image, or a damaged one; the message refers to it as "it".</exception>
    public static void Check(byte[] bytes, int start, int length)
    {
        try
        {
            using var message = new CodedInputStream(bytes, start, length);
            while (message.ReadTag() is not 0 and var tag)
            {
                if (WireFormat.GetTagFieldNumber(tag) == DataField)
                {
                    ImageHeader.Read(new MemoryStream(message.ReadBytes().ToByteArray()));
                    return;
                }

                message.SkipLastField();
            }
        }
        catch (InvalidProtocolBufferException e)
        {
            throw new DatasetFormatException("it is not a protobuf message.", e);
        }

        throw new DatasetFormatException("it has no image.");
    }
}
