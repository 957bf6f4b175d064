using Harvester.Sessions.Imaging;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.ImageLibraries;

/// <summary>The project's decoders, which read files by their paths; the time of a write to a file in memory is part of theirs.</summary>
internal sealed class OwnDecoders : IImageLibrary
{
    private static readonly string FilePath = Path.Combine(
        Directory.Exists("/dev/shm") ? "/dev/shm" : Path.GetTempPath(),
        Path.GetRandomFileName()
    );

    public string Name => "this project";

    public byte[] Decode(byte[] file)
    {
        File.WriteAllBytes(FilePath, file);
        return PictureReader.Read(FilePath).Bytes;
    }

    public bool IsRefusal(Exception exception) => exception is DatasetFormatException;
}
