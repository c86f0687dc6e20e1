"""The official client of the Model Context Protocol on `scenelang mcp`: mcp_client.py BINARY FOLDER

The folder has study.scene, which can be laid out, and torn.scene, which contradicts itself.
"""

import base64
import sys

import anyio
from mcp import ClientSession, MCPError
from mcp.client.stdio import StdioServerParameters, stdio_client


def expect(holds, what):
    if not holds:
        sys.exit(f"not so: {what}")


async def talk(binary, folder):
    server = StdioServerParameters(command=binary, args=["mcp", folder])
    async with stdio_client(server) as (read, write), ClientSession(read, write) as session:
        await session.initialize()
        tools = {tool.name for tool in (await session.list_tools()).tools}
        print(f"{len(tools)} tools")
        resources = {str(r.uri) for r in (await session.list_resources()).resources}
        expect("scenelang://guide" in resources and "scenelang://program/study.scene" in resources, resources)
        guide = (await session.read_resource("scenelang://guide")).contents[0].text
        expect("assert" in guide, "the guide shows the language")

        async def call(tool, **arguments):
            return await session.call_tool(tool, arguments)

        solved = await call("solve", file="study.scene")
        expect(not solved.is_error and solved.structured_content["ok"], solved)
        shown = await call("render", file="study.scene")
        expect(shown.content[1].type == "image", shown.content[1].type)
        expect(base64.b64decode(shown.content[1].data).startswith(b"\x89PNG"), "it is a PNG")
        torn = await call("why_not", file="torn.scene")
        expect(torn.structured_content["contradiction"], torn)
        outside = await call("check", file="../secret.scene")
        expect(outside.is_error and "outside the workspace" in outside.content[0].text, outside)
        try:
            await call("demolish")
            sys.exit("a tool that is not there was called")
        except MCPError as error:
            expect("there is no tool" in str(error), error)


anyio.run(talk, sys.argv[1], sys.argv[2])
