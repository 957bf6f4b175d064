using System;
using System.Formats.Tar;
using System.Globalization;
using System.IO;
using System.Text;
using System.Text.RegularExpressions;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sessions;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Pairs;

/// <summary>
/// WebDataset archives (ustar) of moments: one sample each, with the label and all pictures. An archive is written under a temporary name
/// and renamed when it is full.
/// </summary>
/// <param name="folder">Where the archives go.</param>
/// <param name="written">Called with the path of each archive.</param>
internal sealed class PairArchives(string folder, Action<string> written) : IDisposable
{
    /// <summary>After so many bytes of content, the next sample begins another archive.</summary>
    private const long MaxBytes = 1L << 30;

    private static readonly Regex Name = new(@"\Apairs-[0-9]{6}\.tar\z", RegexOptions.CultureInvariant);

    private string? _temporary;
    private TarWriter? _tar;
    private long _bytes;
    private int _number;

    private string Current => string.Create(CultureInfo.InvariantCulture, $"pairs-{_number:D6}.tar");

    /// <summary>Whether a file has the name of an archive.</summary>
    public static bool IsName(string name) => Name.IsMatch(name);

    /// <summary>Adds a moment.</summary>
    /// <returns>The name of its archive.</returns>
    /// <exception cref="DatasetFormatException">A picture is missing or too large.</exception>
    public string Add(PairGroup group, SessionReader session)
    {
        if (_bytes >= MaxBytes)
        {
            End();
            _number++;
        }

        if (_tar is null)
        {
            _temporary = AtomicFile.TemporaryFor(Path.Combine(folder, Current));
            _tar = new TarWriter(new FileStream(_temporary, FileMode.CreateNew), TarEntryFormat.Ustar, leaveOpen: false);
        }

        Add($"{group.Key}.json", Encoding.UTF8.GetBytes(group.Line.Text));
        foreach (PairImage image in group.Images)
        {
            Add($"{group.Key}.{image.Name}", InputFile.ReadAllBytes(session.PathOf(image.Path), InputFile.MaxPictureBytes));
        }

        return Current;
    }

    /// <summary>Completes the archive that is being written, if there is one.</summary>
    public void End()
    {
        if (_tar is not null)
        {
            _tar.Dispose();
            _tar = null;
            string file = Path.Combine(folder, Current);
            File.Move(_temporary!, file, overwrite: true);
            written(file);
            _bytes = 0;
        }
    }

    /// <summary>Deletes an archive that is not complete.</summary>
    public void Dispose()
    {
        if (_tar is not null)
        {
            _tar.Dispose();
            File.Delete(_temporary!);
        }
    }

    private void Add(string name, byte[] content)
    {
        _bytes += content.Length;
        _tar!.WriteEntry(new UstarTarEntry(TarEntryType.RegularFile, name)
        {
            ModificationTime = DateTimeOffset.UnixEpoch,
            Mode = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.GroupRead | UnixFileMode.OtherRead,
            DataStream = new MemoryStream(content),
        });
    }
}
