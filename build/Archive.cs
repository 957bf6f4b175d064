#:property PublishAot=false
using System.Formats.Tar;
using System.IO.Compression;

// Packs a folder, or packs a zip again, so that the same files give the same bytes: all files have one time and one of two modes; those of a
// folder are in the order of their names, those of a zip keep theirs.
if (args.Length != 2)
{
    Console.Error.WriteLine("Usage: dotnet run build/Archive.cs -- FOLDER|ZIP ARCHIVE.zip|ARCHIVE.tar.gz");
    return 2;
}

const UnixFileMode Readable = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.GroupRead | UnixFileMode.OtherRead;
const UnixFileMode Executable = UnixFileMode.UserExecute | UnixFileMode.GroupExecute | UnixFileMode.OtherExecute;
var time = new DateTimeOffset(2000, 1, 1, 0, 0, 0, TimeSpan.Zero);
string target = args[1];
string temporary = target + ".partial";
Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(target))!);
IEnumerable<Item> items = Directory.Exists(args[0]) ? FilesOf(args[0]) : EntriesOf(args[0]);
if (target.EndsWith(".tar.gz", StringComparison.Ordinal))
{
    WriteTar(items);
}
else
{
    WriteZip(items);
}

File.Move(temporary, target, overwrite: true);
Console.WriteLine(target);
return 0;

static IEnumerable<Item> FilesOf(string folder) =>
    Directory
        .EnumerateFiles(folder, "*", SearchOption.AllDirectories)
        .Select(file => (Path: file, Name: Path.GetRelativePath(folder, file).Replace('\\', '/')))
        .OrderBy(file => file.Name, StringComparer.Ordinal)
        .Select(file => new Item(file.Name, ModeOf(file.Path), File.ReadAllBytes(file.Path)));

static UnixFileMode ModeOf(string file) =>
    !OperatingSystem.IsWindows() && (File.GetUnixFileMode(file) & UnixFileMode.UserExecute) != 0 ? Readable | Executable : Readable;

static List<Item> EntriesOf(string file)
{
    using ZipArchive zip = ZipFile.OpenRead(file);
    List<Item> items = [];
    foreach (ZipArchiveEntry entry in zip.Entries)
    {
        using Stream content = entry.Open();
        using var bytes = new MemoryStream();
        content.CopyTo(bytes);
        items.Add(new Item(entry.FullName, Readable, bytes.ToArray()));
    }

    return items;
}

void WriteZip(IEnumerable<Item> files)
{
    const int ModeShift = 16;
    using ZipArchive zip = new(File.Create(temporary), ZipArchiveMode.Create);
    foreach (Item file in files)
    {
        ZipArchiveEntry entry = zip.CreateEntry(file.Name, CompressionLevel.Optimal);
        entry.LastWriteTime = time;
        entry.ExternalAttributes = (int)file.Mode << ModeShift;
        using Stream content = entry.Open();
        content.Write(file.Content);
    }
}

void WriteTar(IEnumerable<Item> files)
{
    using var zipped = new GZipStream(File.Create(temporary), CompressionLevel.Optimal);
    using TarWriter tar = new(zipped, TarEntryFormat.Ustar);
    foreach (Item file in files)
    {
        tar.WriteEntry(
            new UstarTarEntry(TarEntryType.RegularFile, file.Name)
            {
                Mode = file.Mode,
                ModificationTime = time,
                DataStream = new MemoryStream(file.Content),
            }
        );
    }
}

internal sealed record Item(string Name, UnixFileMode Mode, byte[] Content);
