using System.Text;
using Harvester.Datasets.Files;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports;

/// <summary>Receives the output of a writer for one frame. Files are written at once; parts are kept for the journal.</summary>
public sealed class FrameOutput
{
    private static readonly UTF8Encoding Utf8 = new(encoderShouldEmitUTF8Identifier: false);

    private readonly DatasetFolder _folder;
    private readonly ImageTransfer _transfer;
    private readonly PictureEncoder? _encoder;
    private readonly Func<ExportFrame, FileDigest> _imageDigest;
    private readonly List<KeyValuePair<string, FileDigest>> _files = [];
    private readonly List<KeyValuePair<string, string>> _parts = [];

    internal FrameOutput(DatasetFolder folder, ImageTransfer transfer, PictureEncoder? encoder, Func<ExportFrame, FileDigest> imageDigest)
    {
        _folder = folder;
        _transfer = transfer;
        _encoder = encoder;
        _imageDigest = imageDigest;
    }

    internal IReadOnlyList<KeyValuePair<string, FileDigest>> Files => _files;

    internal IReadOnlyList<KeyValuePair<string, string>> Parts => _parts;

    /// <summary>Adds the image of a frame to the dataset, in the format of the export.</summary>
    /// <param name="path">Path in the dataset, with forward slashes.</param>
    /// <param name="frame">The frame.</param>
    /// <exception cref="DatasetFormatException">The image must be converted and cannot be read.</exception>
    public void Image(string path, ExportFrame frame)
    {
        if (frame.IsImageConverted)
        {
            File(path, stream => _encoder!.Write(frame.ReadImage(), stream));
            return;
        }

        _folder.Transfer(path, frame.ImagePath, _transfer);
        _files.Add(new(path, _imageDigest(frame)));
    }

    /// <summary>Adds the image of the frame before, of the same view, in the format of the export.</summary>
    /// <param name="path">Path in the dataset, with forward slashes.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="flow">The flow between both.</param>
    /// <exception cref="DatasetFormatException">The image must be converted and cannot be read.</exception>
    internal void ImageBefore(string path, ExportFrame frame, FlowLabel flow)
    {
        string name = frame.ImageBefore(flow);
        if (frame.IsImageConverted)
        {
            File(path, stream => _encoder!.Write(frame.ReadImage(name), stream));
            return;
        }

        _folder.Transfer(path, frame.PathOf(name), _transfer);
        _files.Add(new(path, FileDigest.OfFile(frame.PathOf(name))));
    }

    /// <summary>The bytes that <see cref="Image"/> would write.</summary>
    /// <exception cref="DatasetFormatException">The image must be converted and cannot be read.</exception>
    public byte[] ImageBytes(ExportFrame frame)
    {
        if (!frame.IsImageConverted)
        {
            return InputFile.ReadAllBytes(frame.ImagePath, InputFile.MaxPictureBytes);
        }

        using var bytes = new MemoryStream();
        _encoder!.Write(frame.ReadImage(), bytes);
        return bytes.ToArray();
    }

    /// <summary>Writes a text file.</summary>
    public void Text(string path, string content) => File(path, stream => stream.Write(Utf8.GetBytes(content)));

    /// <summary>Writes a file.</summary>
    public void File(string path, Action<Stream> write) => _files.Add(new(path, _folder.Write(path, write)));

    /// <summary>Adds the image of a frame as a temporary file that becomes a part of an aggregate file.</summary>
    /// <param name="part">Name of the part.</param>
    /// <param name="frame">The frame.</param>
    internal void StagedImage(string part, ExportFrame frame)
    {
        string path = $"{DatasetFolder.Staging}/{frame.Name}{frame.ImageExtension}";
        Image(path, frame);
        Part(part, path);
    }

    /// <summary>Writes a temporary file that becomes a part of an aggregate file.</summary>
    /// <param name="part">Name of the part.</param>
    /// <param name="name">Name of the file, unique to this frame.</param>
    /// <param name="write">Writes the content.</param>
    public void StagedPart(string part, string name, Action<Stream> write)
    {
        string path = $"{DatasetFolder.Staging}/{name}";
        File(path, write);
        Part(part, path);
    }

    /// <summary>Adds a part of an aggregate file: one line, without line end.</summary>
    /// <exception cref="ArgumentException">The part contains a line feed.</exception>
    public void Part(string name, string line)
    {
        if (line.Contains('\n', StringComparison.Ordinal))
        {
            throw new ArgumentException("A part is one line.", nameof(line));
        }

        _parts.Add(new(name, line));
    }
}
