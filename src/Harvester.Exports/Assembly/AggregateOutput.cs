using System.Text;
using Harvester.Datasets.Files;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Assembly;

/// <summary>Writes an aggregate file from the parts of a dataset in progress.</summary>
internal sealed class AggregateOutput : IAggregateOutput, IDisposable
{
    private static readonly UTF8Encoding Utf8 = new(encoderShouldEmitUTF8Identifier: false);

    private readonly Stream _stream;
    private readonly PartStore _parts;
    private readonly DatasetFolder _folder;

    public AggregateOutput(Stream stream, PartStore parts, DatasetFolder folder)
    {
        _stream = stream;
        _parts = parts;
        _folder = folder;
        Text = new StreamWriter(stream, Utf8, leaveOpen: true);
    }

    public TextWriter Text { get; }

    public Stream Bytes
    {
        get
        {
            Text.Flush();
            return _stream;
        }
    }

    public IEnumerable<string> Parts(string name) => _parts.Read(name);

    public string WorkingFile => _folder.PathOf(DatasetFolder.Working + "/made");

    public string PathOfStaged(string path) => _folder.PathOf(path);

    public byte[] Staged(string path) => InputFile.ReadAllBytes(_folder.PathOf(path), InputFile.MaxPictureBytes);

    public void CopyStaged(string path)
    {
        using FileStream staged = InputFile.OpenRead(_folder.PathOf(path));
        staged.CopyTo(Bytes);
    }

    public void Dispose() => Text.Dispose();
}
