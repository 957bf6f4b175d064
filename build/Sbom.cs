#:property PublishAot=false
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json.Nodes;
using System.Xml.Linq;

// Writes a software bill of materials, CycloneDX 1.5 as JSON, from the assets file that a restore leaves behind.
// It has no serial number and no time, so the same packages give the same bytes.
if (args.Length != 4)
{
    Console.Error.WriteLine("Usage: dotnet run build/Sbom.cs -- PROJECT-FOLDER NAME VERSION FILE");
    return 2;
}

string name = args[1];
string version = args[2];
JsonNode assets = JsonNode.Parse(File.ReadAllText(Path.Combine(args[0], "obj", "project.assets.json")))!;
string[] packageFolders = [.. assets["packageFolders"]!.AsObject().Select(folder => folder.Key)];
string root = $"{name}@{version}";
JsonArray components = [];
JsonArray references = [];
foreach ((string key, JsonNode? library) in PackagesThatShip(assets))
{
    string[] nameAndVersion = key.Split('/');
    string url = $"pkg:nuget/{nameAndVersion[0]}@{nameAndVersion[1]}";
    components.Add(new JsonObject
    {
        ["type"] = "library",
        ["bom-ref"] = url,
        ["name"] = nameAndVersion[0],
        ["version"] = nameAndVersion[1],
        ["hashes"] = new JsonArray(new JsonObject
        {
            ["alg"] = "SHA-512",
            ["content"] = Convert.ToHexStringLower(Convert.FromBase64String((string)library!["sha512"]!)),
        }),
        ["licenses"] = new JsonArray(new JsonObject { ["expression"] = LicenceOf((string)library["path"]!) }),
        ["purl"] = url,
    });
    references.Add(url);
}

JsonObject bom = new()
{
    ["bomFormat"] = "CycloneDX",
    ["specVersion"] = "1.5",
    ["version"] = 1,
    ["metadata"] = new JsonObject
    {
        ["component"] = new JsonObject
        {
            ["type"] = "application",
            ["bom-ref"] = root,
            ["name"] = name,
            ["version"] = version,
            ["licenses"] = new JsonArray(new JsonObject { ["expression"] = "MIT" }),
        },
    },
    ["components"] = components,
    ["dependencies"] = new JsonArray(new JsonObject { ["ref"] = root, ["dependsOn"] = references }),
};

string temporary = args[3] + ".partial";
Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(temporary))!);
File.WriteAllText(temporary, bom.ToJsonString(new() { WriteIndented = true, NewLine = "\n" }) + "\n", new UTF8Encoding(false));
File.Move(temporary, args[3], overwrite: true);
Console.WriteLine(args[3]);
return 0;

// Reference assemblies have no file for the runtime.
static IEnumerable<KeyValuePair<string, JsonNode?>> PackagesThatShip(JsonNode assets)
{
    HashSet<string> shipped = [.. assets["targets"]!.AsObject()
        .SelectMany(target => target.Value!.AsObject())
        .Where(library => (string)library.Value!["type"]! == "package" && library.Value!["runtime"] is JsonObject)
        .Select(library => library.Key)];
    return assets["libraries"]!.AsObject().Where(library => shipped.Contains(library.Key)).OrderBy(library => library.Key, StringComparer.Ordinal);
}

string LicenceOf(string packagePath)
{
    string folder = packageFolders.Select(parent => Path.Combine(parent, packagePath)).First(Directory.Exists);
    XElement package = XDocument.Load(Directory.EnumerateFiles(folder, "*.nuspec").Single()).Root!;
    XElement? licence = package.Descendants().FirstOrDefault(element => element.Name.LocalName == "license");
    return licence?.Attribute("type")?.Value == "expression"
        ? licence.Value
        : throw new InvalidDataException($"{packagePath}: the package states no licence expression; add a rule to build/Sbom.cs.");
}
