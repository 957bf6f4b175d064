using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using Harvester.Datasets.Files;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Datasets.Exports;

/// <summary>Takes what a writer has to say of one frame. Files are written at once; parts are kept for the journal.</summary>
public sealed class FrameOutput
{
    private static readonly UTF8Encoding Utf8 = new(encoderShouldEmitUTF8Identifier: false);

    private readonly DatasetFolder _folder;
    private readonly ImageTransfer _transfer;
    private readonly PictureEncoder? _encoder;
    private readonly List<string> _files = [];
    private readonly List<KeyValuePair<string, string>> _parts = [];

    internal FrameOutput(DatasetFolder folder, ImageTransfer transfer, PictureEncoder? encoder)
    {
        _folder = folder;
        _transfer = transfer;
        _encoder = encoder;
    }

    internal IReadOnlyList<string> Files => _files;

    internal IReadOnlyList<KeyValuePair<string, string>> Parts => _parts;

    /// <summary>Takes a frame's image into the dataset, in the format that the export asks for.</summary>
    /// <param name="path">Its path in the dataset, with forward slashes.</param>
    /// <param name="frame">The frame.</param>
    /// <exception cref="DatasetFormatException">The image has to be converted and cannot be read.</exception>
    public void Image(string path, ExportFrame frame)
    {
        if (frame.IsImageConverted)
        {
            File(path, stream => _encoder!.Write(frame.ReadImage(), stream));
            return;
        }

        _folder.Transfer(path, frame.ImagePath, _transfer);
        _files.Add(path);
    }

    /// <summary>The bytes that <see cref="Image"/> would write.</summary>
    /// <exception cref="DatasetFormatException">The image has to be converted and cannot be read.</exception>
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
    public void File(string path, Action<Stream> write)
    {
        _folder.Write(path, write);
        _files.Add(path);
    }

    /// <summary>Writes a file that becomes a part of an aggregate file and does not stay.</summary>
    /// <param name="part">Name of the part.</param>
    /// <param name="name">A name for the file that no other frame uses.</param>
    /// <param name="write">Writes it.</param>
    public void StagedPart(string part, string name, Action<Stream> write)
    {
        string path = $"{DatasetFolder.Staging}/{name}";
        File(path, write);
        Part(part, path);
    }

    /// <summary>Hands over a part of an aggregate file: one line, without its end.</summary>
    /// <exception cref="ArgumentException">It has a line feed.</exception>
    public void Part(string name, string line)
    {
        if (line.Contains('\n', StringComparison.Ordinal))
        {
            throw new ArgumentException("A part is one line.", nameof(line));
        }

        _parts.Add(new(name, line));
    }
}
