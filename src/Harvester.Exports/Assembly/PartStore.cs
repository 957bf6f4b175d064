using System.Globalization;
using System.Text;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Assembly;

/// <summary>Sorts the parts of all frames by name into files, so that datasets of any length need little memory.</summary>
internal sealed class PartStore
{
    private const int MaxBufferedCharacters = 4 * 1024 * 1024;

    private readonly string _folder;
    private readonly SortedDictionary<string, StringBuilder> _buffers = new(StringComparer.Ordinal);
    private readonly Dictionary<string, string> _files = new(StringComparer.Ordinal);
    private readonly SortedDictionary<string, int> _counts = new(StringComparer.Ordinal);
    private int _buffered;

    public PartStore(string folder)
    {
        _folder = folder;
        if (Directory.Exists(folder))
        {
            // Left by a killed assembly.
            Directory.Delete(folder, recursive: true);
        }

        Directory.CreateDirectory(folder);
    }

    /// <summary>Number of parts of each name, in ordinal order.</summary>
    public IReadOnlyDictionary<string, int> Counts => _counts;

    public void Add(string name, string line)
    {
        if (!_buffers.TryGetValue(name, out StringBuilder? buffer))
        {
            buffer = new StringBuilder();
            _buffers.Add(name, buffer);
            _files.TryAdd(name, Path.Combine(_folder, _files.Count.ToString(CultureInfo.InvariantCulture)));
        }

        _counts[name] = _counts.GetValueOrDefault(name) + 1;
        buffer.Append(line).Append('\n');
        _buffered += line.Length + 1;
        if (_buffered > MaxBufferedCharacters)
        {
            Flush();
        }
    }

    public void Flush()
    {
        foreach ((string name, StringBuilder buffer) in _buffers)
        {
            using var file = new StreamWriter(AppendedFile.Open(_files[name]));
            foreach (ReadOnlyMemory<char> chunk in buffer.GetChunks())
            {
                file.Write(chunk.Span);
            }
        }

        _buffers.Clear();
        _buffered = 0;
    }

    /// <summary>The parts of a name, in the order of adding; empty if there are none.</summary>
    public IEnumerable<string> Read(string name) => _files.TryGetValue(name, out string? file) ? InputFile.ReadLines(file) : [];
}
