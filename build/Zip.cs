#:property PublishAot=false
using System;
using System.IO;
using System.IO.Compression;
using System.Linq;

// Packs a folder so that the same files give the same bytes: in the order of their names, all with one time.
if (args.Length != 2)
{
    Console.Error.WriteLine("Usage: dotnet run build/Zip.cs -- FOLDER ZIP");
    return 2;
}

var time = new DateTimeOffset(2000, 1, 1, 0, 0, 0, TimeSpan.Zero);
string temporary = args[1] + ".partial";
using (ZipArchive zip = new(File.Create(temporary), ZipArchiveMode.Create))
{
    foreach (string file in Directory.EnumerateFiles(args[0]).Order(StringComparer.Ordinal))
    {
        ZipArchiveEntry entry = zip.CreateEntry(Path.GetFileName(file), CompressionLevel.Optimal);
        entry.LastWriteTime = time;
        using Stream content = entry.Open();
        using Stream source = File.OpenRead(file);
        source.CopyTo(content);
    }
}

File.Move(temporary, args[1], overwrite: true);
Console.WriteLine(args[1]);
return 0;
